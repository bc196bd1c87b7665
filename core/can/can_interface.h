// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"
#include "core/can/interface_report.h"

#include <QObject>
#include <QSocketNotifier>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

// A CAN network interface as SocketCanLink sees it: a socket, whether the interface is up, and what the kernel reports
// of it. Behind an abstract class because most machines that build us have no AF_CAN. Lives with its link.
namespace boresight::socketcan {

enum class InterfaceState
{
    Absent,  // removed, or another one took its name
    Down,
    Up,
};

class CanInterface : public QObject
{
    Q_OBJECT

public:
    // A non-blocking socket that carries whole CAN and CAN-FD frames and error frames. An error names the remedy.
    [[nodiscard]] virtual Result<FileDescriptor> openSocket() = 0;
    // Of the interface that the last socket belongs to.
    [[nodiscard]] virtual InterfaceState state() const = 0;
    // Kind, bit timing and controller; nothing if the kernel does not answer. Only the texts depend on it.
    [[nodiscard]] virtual std::optional<InterfaceReport> report() const = 0;

Q_SIGNALS:
    // Some network interface changed: ask for state() again.
    void changed();
};

// The real one: AF_CAN. The kernel reports changes (rtnetlink) at once, also when nothing is being sent.
class KernelCanInterface final : public CanInterface
{
    Q_OBJECT

public:
    explicit KernelCanInterface(QString name) : m_name(std::move(name)) {}

    [[nodiscard]] Result<FileDescriptor> openSocket() override;
    [[nodiscard]] InterfaceState state() const override;
    [[nodiscard]] std::optional<InterfaceReport> report() const override;

private:
    [[nodiscard]] Result<> findInterface(int socket);
    void watchChanges();
    void readChanges();

    QString m_name;
    int m_index = 0;
    FileDescriptor m_changes;
    std::unique_ptr<QSocketNotifier> m_changesNotifier;
};

}  // namespace boresight::socketcan

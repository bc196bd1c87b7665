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

// The services of a CAN network interface for SocketCanLink: a socket, the state of the interface, and the report of
// the kernel about it. An abstract class, because most machines that build Boresight have no AF_CAN. Lives with its
// link.
namespace boresight::socketcan {

enum class InterfaceState
{
    Absent,  // removed, or another interface has its name now
    Down,
    Up,
};

class CanInterface : public QObject
{
    Q_OBJECT

public:
    // A non-blocking socket for whole CAN and CAN-FD frames and error frames. An error contains the remedy.
    [[nodiscard]] virtual Result<FileDescriptor> openSocket() = 0;
    // The state of the interface of the last socket.
    [[nodiscard]] virtual InterfaceState state() const = 0;
    // Kind, bit timing and controller. Empty if the kernel does not answer. Only texts depend on it.
    [[nodiscard]] virtual std::optional<InterfaceReport> report() const = 0;

Q_SIGNALS:
    // Some network interface changed, so state() must be called again.
    void changed();
};

// The real interface: AF_CAN. The kernel reports changes (rtnetlink) at once, also while nothing is sent.
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

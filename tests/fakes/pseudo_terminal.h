// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"

#include <QByteArray>
#include <QSocketNotifier>
#include <QString>

#include <memory>
#include <utility>

// A pseudo-terminal whose far end is in the test's hand: what stands behind /dev/… for the code under test. Raw mode;
// everything the code writes is collected in `written`.
namespace boresight::fakes {

class PseudoTerminal
{
public:
    PseudoTerminal();
    [[nodiscard]] QString path() const { return m_path; }
    void write(const QByteArray& bytes);
    void unplug();  // the device disappears
    QByteArray takeWritten() { return std::exchange(written, {}); }

    QByteArray written;

private:
    void read();

    FileDescriptor m_device;
    FileDescriptor m_numberKeeper;
    QString m_path;
    std::unique_ptr<QSocketNotifier> m_notifier;
};

}  // namespace boresight::fakes

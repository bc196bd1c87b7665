// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"

#include <QByteArray>
#include <QSocketNotifier>
#include <QString>

#include <memory>
#include <utility>

// A pseudo-terminal. The test holds the far end. For the code under test it is a serial device /dev/…. Raw mode.
// Everything that the code writes is collected in `written`.
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

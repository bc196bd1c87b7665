// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/pseudo_terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>

namespace boresight::fakes {

PseudoTerminal::PseudoTerminal() : m_device(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
{
    std::array<char, 64> name{};
    EXPECT_EQ(grantpt(m_device.number()), 0);
    EXPECT_EQ(unlockpt(m_device.number()), 0);
    EXPECT_EQ(ptsname_r(m_device.number(), name.data(), name.size()), 0);
    m_path = QString::fromLatin1(name.data());
    m_notifier = std::make_unique<QSocketNotifier>(m_device.number(), QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(), [this] { read(); });
}

void PseudoTerminal::write(const QByteArray& bytes)
{
    EXPECT_EQ(::write(m_device.number(), bytes.constData(), static_cast<std::size_t>(bytes.size())), bytes.size());
}

// The kernel gives the number to the next terminal as soon as both ends are closed. QSerialPort closes its end before
// it removes its lock file, so another test could find its new terminal locked. Therefore the number is kept in use.
void PseudoTerminal::unplug()
{
    m_numberKeeper = FileDescriptor(open(m_path.toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    m_notifier.reset();
    m_device.reset();
}

void PseudoTerminal::read()
{
    std::array<char, 4096> buffer{};
    const ssize_t size = ::read(m_device.number(), buffer.data(), buffer.size());
    if (size > 0) {
        written.append(buffer.data(), static_cast<qsizetype>(size));
    } else {
        m_notifier->setEnabled(false);  // the code under test closed its end: EIO until it opens it again
    }
}

}  // namespace boresight::fakes

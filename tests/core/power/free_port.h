// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUdpSocket>

#include <gtest/gtest.h>

namespace boresight::power {

// Free a moment ago.
inline std::uint16_t freePort()
{
    QUdpSocket udp;
    EXPECT_TRUE(udp.bind(QHostAddress::LocalHost, 0));
    return udp.localPort();
}

}  // namespace boresight::power

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/peer_address.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

TEST(PeerAddress, TellsTheHost)
{
    EXPECT_EQ(hostOf("127.0.0.1:51234"), "127.0.0.1");
    EXPECT_EQ(hostOf("[::1]:51234"), "::1");
    EXPECT_EQ(hostOf("[fe80::1%eth0]:5"), "fe80::1%eth0");
}

TEST(PeerAddress, IsWrittenWithItsPort)
{
    EXPECT_EQ(addressText(QHostAddress(QStringLiteral("127.0.0.1")), 5), "127.0.0.1:5");
    EXPECT_EQ(addressText(QHostAddress(QStringLiteral("::ffff:10.0.0.7")), 12000), "10.0.0.7:12000");
    EXPECT_EQ(addressText(QHostAddress(QStringLiteral("::1")), 51234), "[::1]:51234");
}

TEST(PeerAddress, IsWhereAProgramListens)
{
    EXPECT_TRUE(listenAddress("localhost").isLoopback());
    EXPECT_EQ(listenAddress("0.0.0.0"), QHostAddress(QHostAddress::AnyIPv4));
    EXPECT_TRUE(listenAddress("shack.example").isNull());
}

TEST(PeerAddress, ComparesHostsNotSpellings)
{
    EXPECT_TRUE(sameHost("::1", "0:0:0:0:0:0:0:1"));
    EXPECT_TRUE(sameHost("::ffff:10.0.0.7", "10.0.0.7"));
    EXPECT_FALSE(sameHost("10.0.0.7", "10.0.0.70"));
    EXPECT_FALSE(sameHost("", ""));
    EXPECT_FALSE(sameHost("unknown", "unknown"));
}

TEST(PeerAddress, KnowsThisComputer)
{
    for (const char* const host : {"localhost", "127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"}) {
        EXPECT_TRUE(isThisComputer(host)) << host;
    }
    for (const char* const host : {"", "10.0.0.7", "0.0.0.0", "broker.lan", "localhost.lan"}) {
        EXPECT_FALSE(isThisComputer(host)) << host;
    }
}

// REQ-ROTCTLD-09 (AllowList.*): Only the addresses and networks of `rotctld.allow` may connect. Others are
// disconnected at once, with a line in the log, also when the list changes while they are connected.
TEST(AllowList, EmptyAdmitsEverybody)
{
    EXPECT_TRUE(AllowList().admits("203.0.113.5"));
    EXPECT_TRUE(AllowList(std::vector<std::string>{}).admits("::1"));
}

TEST(AllowList, AdmitsAddressesAndNetworks)
{
    const AllowList list({"192.168.1.7", "10.0.0.0/8", "172.16.4.0/22", "fd00::/8", "::1"});
    for (const char* const host : {"192.168.1.7", "10.0.0.1", "10.255.255.255", "172.16.7.255", "fd12:3456::1", "::1",
                                   "::ffff:10.1.2.3", "::ffff:192.168.1.7"}) {
        EXPECT_TRUE(list.admits(host)) << host;
    }
    for (const char* const host :
         {"192.168.1.8", "11.0.0.0", "172.16.8.0", "fe80::1", "::2", "127.0.0.1", "::ffff:11.1.2.3", "unknown", ""}) {
        EXPECT_FALSE(list.admits(host)) << host;
    }
}

TEST(AllowList, AWholeProtocolIsANetworkToo)
{
    const AllowList list({"0.0.0.0/0"});
    EXPECT_TRUE(list.admits("203.0.113.5"));
    EXPECT_FALSE(list.admits("::1"));
}

TEST(AllowList, AnUnreadableEntryAdmitsNobody)
{
    const AllowList list({"shack.example", "10.0.0.0/99"});
    EXPECT_FALSE(list.admits("10.0.0.1"));
    EXPECT_FALSE(list.admits("unknown"));
}

}  // namespace
}  // namespace boresight

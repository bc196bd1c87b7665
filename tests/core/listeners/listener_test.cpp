// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/listeners/listener.h"

#include <gtest/gtest.h>

namespace boresight::listeners {
namespace {

QString refusalOf(std::string_view text)
{
    const auto read = parseListener(text);
    return read ? QStringLiteral("accepted") : read.error().text;
}

// REQ-LISTENERS-01: A line in the profile describes one listener: protocol, rights, place, and who may connect. A line
// with an unknown part is refused, and the refusal names that part.
TEST(Listener, IsReadFromALineOfTheProfile)
{
    EXPECT_EQ(parseListener("gs232b drive tcp:127.0.0.1:4534"),
              (Listener{.protocol = Protocol::Gs232B, .rights = Rights::Drive, .host = "127.0.0.1", .port = 4534}));
    EXPECT_EQ(parseListener("  gs232a   read tcp:[::]:0 192.168.1.0/24 fe80::1 "),
              (Listener{.protocol = Protocol::Gs232A,
                        .rights = Rights::Read,
                        .host = "::",
                        .port = 0,
                        .allow = {"192.168.1.0/24", "fe80::1"}}));
    EXPECT_EQ(parseListener("gs232a read pty:/tmp/rotator"),
              (Listener{.protocol = Protocol::Gs232A, .rights = Rights::Read, .pty = "/tmp/rotator", .host = {}}));
    EXPECT_EQ(
        parseListener("pairs drive unix:/tmp/pairs"),
        (Listener{
            .protocol = Protocol::Pairs, .rights = Rights::Drive, .pty = {}, .unixPath = "/tmp/pairs", .host = {}}));
    for (const auto& [word, protocol, name] : {std::tuple("easycomm1", Protocol::Easycomm1, "EasyComm I"),
                                               std::tuple("easycomm2", Protocol::Easycomm2, "EasyComm II"),
                                               std::tuple("easycomm3", Protocol::Easycomm3, "EasyComm III")}) {
        const auto listener = parseListener(std::string(word) + " drive pty:/tmp/rotator");
        ASSERT_TRUE(listener) << word;
        EXPECT_EQ(listener->protocol, protocol);
        EXPECT_EQ(nameOf(listener->protocol), name);
    }
}

TEST(Listener, NamesTheWordThatIsWrong)
{
    EXPECT_TRUE(refusalOf("").contains(QStringLiteral("protocol, rights and place")));
    EXPECT_TRUE(refusalOf("gs232b drive").contains(QStringLiteral("protocol, rights and place")));
    EXPECT_TRUE(refusalOf("gs233 drive tcp:127.0.0.1:1").contains(QStringLiteral("\"gs233\"")));
    EXPECT_TRUE(refusalOf("easycomm drive tcp:127.0.0.1:1").contains(QStringLiteral("gs232b, easycomm1, easycomm2")));
    EXPECT_TRUE(refusalOf("gs232a write tcp:127.0.0.1:1").contains(QStringLiteral("\"write\"")));
    for (const char* const place :
         {"tcp:127.0.0.1", "tcp:127.0.0.1:65536", "tcp:127.0.0.1:-1", "tcp:rotator.local:4534", "tcp::4534",
          "udp:127.0.0.1:4534", "unix:rotator", "unix:/tmp/", "pty:rotator", "pty:/tmp/", "/tmp/rotator"}) {
        EXPECT_TRUE(refusalOf(std::string("gs232a drive ") + place).contains(QString::fromLatin1(place))) << place;
    }
    EXPECT_TRUE(refusalOf("gs232a drive tcp:0.0.0.0:4534 10.0.0.0/8 shack").contains(QStringLiteral("\"shack\"")));
    EXPECT_TRUE(refusalOf("gs232a drive pty:/tmp/r 10.0.0.0/8").contains(QStringLiteral("must not follow a path")));
    EXPECT_TRUE(refusalOf("pairs drive unix:/tmp/r 10.0.0.0/8").contains(QStringLiteral("must not follow a path")));
}

TEST(Listener, SaysWhereItIsAndWhoReachesIt)
{
    EXPECT_EQ(placeOf(*parseListener("gs232a drive tcp:[::1]:4534")), "[::1]:4534");
    EXPECT_EQ(placeOf(*parseListener("gs232a drive pty:/tmp/r")), "/tmp/r");
    EXPECT_EQ(placeOf(*parseListener("pairs drive unix:/tmp/r")), "/tmp/r");
    EXPECT_FALSE(isOpenToAll(*parseListener("pairs drive unix:/tmp/r")));
    EXPECT_TRUE(isOpenToAll(*parseListener("gs232a drive tcp:0.0.0.0:4534")));
    EXPECT_FALSE(isOpenToAll(*parseListener("gs232a read tcp:0.0.0.0:4534")));
    EXPECT_FALSE(isOpenToAll(*parseListener("gs232a drive tcp:0.0.0.0:4534 10.0.0.0/8")));
    EXPECT_FALSE(isOpenToAll(*parseListener("gs232a drive tcp:127.0.0.1:4534")));
    EXPECT_FALSE(isOpenToAll(*parseListener("gs232a drive tcp:localhost:4534")));
    EXPECT_FALSE(isOpenToAll(*parseListener("gs232a drive pty:/tmp/r")));
}

TEST(Listener, TwoNeedTwoPlaces)
{
    const auto one = *parseListener("gs232a drive tcp:127.0.0.1:4534");
    EXPECT_TRUE(collide(one, *parseListener("gs232b read tcp:127.0.0.1:4534")));
    EXPECT_FALSE(collide(one, *parseListener("gs232b read tcp:127.0.0.1:4535")));
    const auto any = *parseListener("gs232a drive tcp:127.0.0.1:0");
    EXPECT_FALSE(collide(any, any));
    const auto terminal = *parseListener("gs232a drive pty:/tmp/r");
    EXPECT_TRUE(collide(terminal, terminal));
    EXPECT_TRUE(collide(terminal, *parseListener("pairs drive unix:/tmp/r")));
    EXPECT_FALSE(collide(terminal, *parseListener("pairs drive unix:/tmp/s")));
}

}  // namespace
}  // namespace boresight::listeners

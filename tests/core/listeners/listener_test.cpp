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

// REQ-LISTENERS-09: Programs that send datagrams have a UDP port. A line for N1MM may end with the name of its rotor. A
// UDP port that other computers reach and that may move the mount needs a list of addresses.
TEST(Listener, MayBeForDatagrams)
{
    EXPECT_EQ(
        parseListener("pst drive udp:127.0.0.1:12000"),
        (Listener{
            .protocol = Protocol::Pst, .rights = Rights::Drive, .host = "127.0.0.1", .port = 12000, .udp = true}));
    EXPECT_EQ(parseListener("n1mm read udp:0.0.0.0:12040 192.168.1.0/24 rotor= Yagi 20 "),
              (Listener{.protocol = Protocol::N1mm,
                        .rights = Rights::Read,
                        .host = "0.0.0.0",
                        .port = 12040,
                        .allow = {"192.168.1.0/24"},
                        .udp = true,
                        .rotor = "Yagi 20"}));
    EXPECT_EQ(nameOf(Protocol::Pst), "PstRotator");
    EXPECT_EQ(nameOf(Protocol::N1mm), "N1MM");
    for (const char* const line : {"pst drive tcp:127.0.0.1:12000", "n1mm drive pty:/tmp/r", "pst drive unix:/tmp/r"}) {
        EXPECT_TRUE(refusalOf(line).contains(QStringLiteral("is not served at"))) << line;
    }
    for (const char* const line : {"n1mm drive udp:127.0.0.1:12040 rotor=", "pst drive udp:127.0.0.1:12000 rotor=Yagi",
                                   "n1mm drive udp:127.0.0.1:12040 rotor=  "}) {
        EXPECT_TRUE(refusalOf(line).contains(QStringLiteral("\"rotor=\""))) << line;
    }
    for (const char* const line : {"pst drive udp:0.0.0.0:12000", "n1mm drive udp:192.168.1.2:12040 rotor=Yagi"}) {
        EXPECT_TRUE(refusalOf(line).contains(QStringLiteral("Add the permitted addresses"))) << line;
    }
    EXPECT_TRUE(parseListener("pst read udp:0.0.0.0:12000"));
    EXPECT_TRUE(refusalOf("pst drive udp:127.0.0.1:65535").contains(QStringLiteral("the port after its own")));
    EXPECT_TRUE(parseListener("n1mm drive udp:127.0.0.1:65535"));
    EXPECT_TRUE(refusalOf("pst drive udp:shack:12000").contains(QStringLiteral("\"udp:shack:12000\"")));
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
    EXPECT_EQ(placeOf(*parseListener("pst drive udp:[::1]:12000")), "UDP [::1]:12000");
    EXPECT_FALSE(isOpenToAll(*parseListener("n1mm drive udp:0.0.0.0:12040 10.0.0.7")));
    EXPECT_TRUE(isOpenToForgery(*parseListener("n1mm drive udp:0.0.0.0:12040 10.0.0.7")));
    EXPECT_FALSE(isOpenToForgery(*parseListener("n1mm read udp:0.0.0.0:12040 10.0.0.7")));
    EXPECT_FALSE(isOpenToForgery(*parseListener("n1mm drive udp:[::1]:12040")));
    EXPECT_FALSE(isOpenToForgery(*parseListener("gs232a drive tcp:0.0.0.0:4534")));
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
    const auto datagrams = *parseListener("pst drive udp:127.0.0.1:4534");
    EXPECT_TRUE(collide(datagrams, *parseListener("n1mm drive udp:127.0.0.1:4534")));
    EXPECT_FALSE(collide(one, datagrams)) << "TCP and UDP have ports of their own";
    for (const char* const place : {"0.0.0.0", "[::]", "localhost"}) {
        const auto other = *parseListener("gs232b read tcp:" + std::string(place) + ":4534");
        EXPECT_TRUE(collide(one, other) && collide(other, one)) << place;
    }
    EXPECT_FALSE(collide(one, *parseListener("gs232b read tcp:127.0.0.2:4534")));
    EXPECT_FALSE(collide(*parseListener("gs232b read tcp:0.0.0.0:4534"), *parseListener("gs232b read tcp:[::1]:4534")));
    const auto terminal = *parseListener("gs232a drive pty:/tmp/r");
    EXPECT_TRUE(collide(terminal, terminal));
    EXPECT_TRUE(collide(terminal, *parseListener("pairs drive unix:/tmp/r")));
    EXPECT_FALSE(collide(terminal, *parseListener("pairs drive unix:/tmp/s")));
}

}  // namespace
}  // namespace boresight::listeners

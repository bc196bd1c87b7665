// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/inlet.h"

#include "core/base/file_descriptor.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/sockios.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <string>

namespace boresight::mqtt {
namespace {

std::optional<std::size_t> lengthOf(const std::vector<std::uint8_t>& bytes)
{
    return packetLength(bytes);
}

// The examples of MQTT 3.1.1, table 2.4.
TEST(PacketLength, IsReadFromTheHeader)
{
    EXPECT_EQ(lengthOf({0xD0, 0x00}), 2U);
    EXPECT_EQ(lengthOf({0x30, 0x7F}), 2U + 127U);
    EXPECT_EQ(lengthOf({0x30, 0x80, 0x01}), 3U + 128U);
    EXPECT_EQ(lengthOf({0x30, 0xFF, 0x7F}), 3U + 16'383U);
    EXPECT_EQ(lengthOf({0x30, 0x80, 0x80, 0x01}), 4U + 16'384U);
    EXPECT_EQ(lengthOf({0x30, 0xFF, 0xFF, 0xFF, 0x7F}), 5U + 268'435'455U);
}

TEST(PacketLength, NeedsTheWholeHeader)
{
    EXPECT_EQ(lengthOf({}), std::nullopt);
    EXPECT_EQ(lengthOf({0x30}), std::nullopt);
    EXPECT_EQ(lengthOf({0x30, 0xFF, 0xFF, 0xFF}), std::nullopt);
    EXPECT_EQ(lengthOf({0x30, 0xFF, 0xFF, 0xFF, 0xFF}), 0U) << "no header of MQTT";
}

// Both ends of a TCP connection on loopback.
class InletTest : public testing::Test
{
protected:
    void SetUp() override
    {
        const FileDescriptor listener(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto* const generic = reinterpret_cast<sockaddr*>(&address);
        ASSERT_EQ(bind(listener.number(), generic, sizeof address), 0);
        ASSERT_EQ(listen(listener.number(), 1), 0);
        socklen_t size = sizeof address;
        ASSERT_EQ(getsockname(listener.number(), generic, &size), 0);
        m_reader = FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        ASSERT_EQ(connect(m_reader.number(), generic, sizeof address), 0);
        m_broker = FileDescriptor(accept4(listener.number(), nullptr, nullptr, SOCK_CLOEXEC));
        ASSERT_TRUE(m_broker.isOpen());
    }
    // Returns when everything has arrived. For small messages only: a TCP window holds about 60 kB.
    void send(const std::string& bytes) const
    {
        const std::size_t expected = left() + bytes.size();
        begin(bytes);
        while (left() < expected) {
        }
    }
    void begin(const std::string& bytes) const
    {
        ASSERT_EQ(::send(m_broker.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }
    [[nodiscard]] bool allArrived() const
    {
        int bytes = 0;
        EXPECT_EQ(ioctl(m_broker.number(), SIOCOUTQ, &bytes), 0);
        return bytes == 0;
    }
    // Runs until only `rest` is left.
    void dropUntil(std::size_t rest)
    {
        while (!allArrived() || left() > rest) {
            if (const std::size_t before = left(); before > rest) {
                ASSERT_FALSE(mayRead());
                ++m_turns;
            }
        }
    }
    // The present result of poll, which the event loop uses.
    [[nodiscard]] bool wakes() const
    {
        pollfd request{.fd = m_reader.number(), .events = POLLIN, .revents = 0};
        return poll(&request, 1, 0) == 1;
    }
    [[nodiscard]] bool mayRead() { return m_inlet.mayRead(m_reader.number()); }
    // Reads as libmosquitto does.
    void read(std::size_t bytes) const
    {
        std::string text(bytes, '\0');
        ASSERT_EQ(recv(m_reader.number(), text.data(), bytes, MSG_WAITALL), static_cast<ssize_t>(bytes));
    }
    [[nodiscard]] std::size_t left() const
    {
        int bytes = 0;
        EXPECT_EQ(ioctl(m_reader.number(), FIONREAD, &bytes), 0);
        return static_cast<std::size_t>(bytes);
    }

    Inlet m_inlet;
    FileDescriptor m_reader;
    FileDescriptor m_broker;
    std::size_t m_turns = 0;
};

std::string publication(std::size_t payload)
{
    const std::size_t rest = payload + 3;
    std::string header("\x30");
    for (std::size_t length = rest; length > 0; length >>= 7U) {
        header += static_cast<char>((length & 0x7FU) | (length > 0x7FU ? 0x80U : 0U));
    }
    return header + std::string("\0\1t", 3) + std::string(payload, 'x');
}

// REQ-MQTT-09e (InletTest.*): A message of more than 64 kB is dropped with one line in the log, and the connection goes
// on. Without TLS the message is never kept in memory.
TEST_F(InletTest, APacketIsReadAsItComesOnceItsLengthIsKnown)
{
    const std::string packet = publication(1000);
    send(packet.substr(0, 1));
    EXPECT_TRUE(wakes());
    EXPECT_FALSE(mayRead());
    EXPECT_FALSE(wakes()) << "until there is more";
    send(packet.substr(1, 500));
    EXPECT_TRUE(wakes());
    EXPECT_TRUE(mayRead());
    read(501);
    EXPECT_TRUE(mayRead()) << "in the middle of it";
    send(packet.substr(501) + publication(Inlet::kLargestPacket).substr(0, 10));
    EXPECT_TRUE(mayRead());
    read(packet.size() - 501);
    EXPECT_FALSE(mayRead()) << "the next one is too large";
    EXPECT_TRUE(m_inlet.takeDropped());
}

TEST_F(InletTest, SmallPacketsAreReadOneByOne)
{
    send(publication(1) + publication(200));
    EXPECT_TRUE(mayRead());
    read(publication(1).size());
    EXPECT_TRUE(mayRead());
    read(publication(200).size());
    EXPECT_FALSE(mayRead()) << "No data";
    EXPECT_FALSE(wakes());
    EXPECT_EQ(m_inlet.takeDropped(), std::nullopt);
}

// Story: the kernel's buffer was full of one large piece, and all of it but half a packet was read. The reader waited
// for the other half, which could not arrive. No values came any more, and the thread ran in a busy loop.
TEST_F(InletTest, AFullBufferIsReadOn)
{
    const std::string packet = publication(320);
    std::string burst;
    while (burst.size() < 600'000) {
        burst += packet;
    }
    ASSERT_EQ(fcntl(m_broker.number(), F_SETFL, O_NONBLOCK), 0);
    std::size_t sent = 0;
    std::size_t taken = 0;
    for (int turn = 0; taken < burst.size() && turn < 1'000'000; ++turn) {
        const ssize_t more = ::send(m_broker.number(), burst.data() + sent, burst.size() - sent, MSG_NOSIGNAL);
        sent += more > 0 ? static_cast<std::size_t>(more) : 0;
        if (mayRead()) {
            std::array<char, 100> piece{};
            const std::size_t rest = packet.size() - taken % packet.size();
            const ssize_t got = recv(m_reader.number(), piece.data(), std::min(piece.size(), rest), MSG_DONTWAIT);
            taken += got > 0 ? static_cast<std::size_t>(got) : 0;
        }
    }
    EXPECT_EQ(taken, burst.size());
}

// Story: a message of 200 MB was kept in memory, and reading it delayed the drives by 0.42 s.
TEST_F(InletTest, AHugePacketIsThrownAwayPieceByPiece)
{
    std::string huge = publication(200'000'000);
    const std::size_t length = huge.size();
    huge.resize(4 * Inlet::kDroppedAtOnce);
    begin(huge);
    dropUntil(0);
    EXPECT_GE(m_turns, 4U);
    EXPECT_EQ(m_inlet.takeDropped(), static_cast<qint64>(length));
    EXPECT_EQ(m_inlet.takeDropped(), std::nullopt) << "told once";
    EXPECT_FALSE(wakes());
}

TEST_F(InletTest, ThePacketAfterAHugeOneIsRead)
{
    const std::string huge = publication(Inlet::kLargestPacket);
    begin(huge + publication(5));
    dropUntil(publication(5).size());
    EXPECT_TRUE(mayRead());
    EXPECT_EQ(left(), publication(5).size());
    EXPECT_EQ(m_inlet.takeDropped(), static_cast<qint64>(huge.size()));
}

TEST_F(InletTest, TheEndOfTheConnectionIsReadByLibmosquittoInEveryPhase)
{
    send(publication(200).substr(0, 1));
    EXPECT_FALSE(mayRead());
    send(publication(200).substr(1, 49));
    EXPECT_TRUE(mayRead());
    read(50);
    m_broker = FileDescriptor();
    EXPECT_TRUE(wakes());
    EXPECT_TRUE(mayRead());
}

TEST_F(InletTest, TheEndComesInAHugePacketToo)
{
    send(publication(1'000'000).substr(0, 10));
    EXPECT_FALSE(mayRead());
    EXPECT_EQ(left(), 0U);
    m_broker = FileDescriptor();
    EXPECT_TRUE(mayRead());
}

TEST_F(InletTest, WhatIsNotMqttIsLeftToLibmosquitto)
{
    send(std::string(8, '\xFF'));
    EXPECT_TRUE(mayRead());
}

}  // namespace
}  // namespace boresight::mqtt

// SPDX-License-Identifier: GPL-3.0-or-later
// With real sockets.
#include "core/datagrams/position_port.h"

#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QUdpSocket>

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace boresight::position {
namespace {

using testing::HasSubstr;

class PositionPortTest : public testing::Test
{
protected:
    void begin()
    {
        port = std::make_unique<PositionPort>(QStringLiteral("127.0.0.1"), number);
        QObject::connect(port.get(), &PositionPort::received, port.get(),
                         [this](const Result<PositionText>& read) { all.push_back(read); });
    }
    void send(const QByteArray& bytes) { sender.writeDatagram(bytes, QHostAddress::LocalHost, number); }
    [[nodiscard]] auto refused() const
    {
        return std::ranges::count_if(all, [](const auto& read) { return !read; });
    }
    // Until it listens: what is sent before is lost.
    [[nodiscard]] bool listens()
    {
        return fakes::waitUntil([this] {
            send("1,1,1");
            return !all.empty();
        });
    }

    std::uint16_t number = fakes::unusedUdpPort();
    QUdpSocket sender;
    std::unique_ptr<PositionPort> port;
    std::vector<Result<PositionText>> all;
};

// REQ-POSITION-20: A datagram is one position, a line or a JSON object. What cannot be read is told with the reason.
TEST_F(PositionPortTest, ADatagramIsOnePosition)
{
    begin();
    ASSERT_TRUE(listens());
    send("38.757,-9.117,1200\n");
    send(R"({"type":"PAYLOAD_SUMMARY","callsign":"X1","latitude":46.25,"longitude":13.5,"altitude":1001.8})");
    send("rubbish");
    send(QByteArray(60'000, 'x'));
    ASSERT_TRUE(fakes::waitUntil([this] { return refused() == 2; }));
    const auto sonde = std::ranges::find_if(all, [](const auto& read) { return read && !read->name.isEmpty(); });
    ASSERT_NE(sonde, all.end());
    EXPECT_EQ((*sonde)->site.latitude, 46.25_deg);
}

// REQ-POSITION-21: Whoever floods the port delays nobody: the station gets the newest 32 every 20 ms.
TEST_F(PositionPortTest, AFloodLeavesTheNewest)
{
    begin();
    ASSERT_TRUE(listens());
    all.clear();
    for (int i = 0; i < 5000; ++i) {
        send("1,1," + QByteArray::number(i));
    }
    ASSERT_TRUE(fakes::waitUntil([this] {
        send("2,2,2");
        return !all.empty() && all.back() && all.back()->site.latitude == 2_deg;
    }));
    EXPECT_LT(all.size(), 5000U);
}

// REQ-POSITION-22: A port that another program uses is reported, and tried again.
TEST_F(PositionPortTest, ATakenPortIsTriedAgain)
{
    auto other = std::make_unique<QUdpSocket>();
    ASSERT_TRUE(other->bind(QHostAddress::LocalHost, number, QAbstractSocket::DontShareAddress));
    begin();
    ASSERT_TRUE(fakes::waitUntil([this] { return !port->trouble().isEmpty(); }));
    EXPECT_THAT(port->trouble().toStdString(), HasSubstr("Boresight cannot listen on UDP 127.0.0.1:"));
    other.reset();
    EXPECT_TRUE(listens());
    EXPECT_EQ(port->trouble(), QString());
}

}  // namespace
}  // namespace boresight::position

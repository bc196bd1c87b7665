// SPDX-License-Identifier: GPL-3.0-or-later
// With real sockets.
#include "core/datagrams/datagram_port.h"

#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QUdpSocket>

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace boresight::datagrams {
namespace {

using testing::HasSubstr;

class DatagramPortTest : public testing::Test
{
protected:
    void begin()
    {
        port = std::make_unique<DatagramPort>(QStringLiteral("test"), QStringLiteral("127.0.0.1"), number);
        QObject::connect(port.get(), &DatagramPort::received, port.get(),
                         [this](const QByteArray& datagram) { all.push_back(datagram); });
    }
    void send(const QByteArray& bytes) { sender.writeDatagram(bytes, QHostAddress::LocalHost, number); }
    // Waits until the port listens. Earlier datagrams are lost.
    [[nodiscard]] bool listens()
    {
        return fakes::waitUntil([this] {
            send("1");
            return !all.empty();
        });
    }

    std::uint16_t number = fakes::unusedUdpPort();
    QUdpSocket sender;
    std::unique_ptr<DatagramPort> port;
    std::vector<QByteArray> all;
};

// REQ-DATAGRAMS-01: A datagram arrives unchanged. Of a longer one the first 4097 bytes arrive, so the reader can detect
// that it is too long.
TEST_F(DatagramPortTest, ADatagramArrivesAsItWasSent)
{
    begin();
    ASSERT_TRUE(listens());
    send("38.757,-9.117,1200\n");
    send(QByteArray(60'000, 'x'));
    ASSERT_TRUE(fakes::waitUntil([this] { return all.back().startsWith('x'); }));
    EXPECT_THAT(all, testing::Contains(QByteArray("38.757,-9.117,1200\n")));
    EXPECT_EQ(all.back().size(), DatagramPort::kLongest + 1);
}

// REQ-DATAGRAMS-02: A flood at the port delays nothing: every 20 ms the station receives the newest 32 datagrams.
TEST_F(DatagramPortTest, AFloodLeavesTheNewest)
{
    begin();
    ASSERT_TRUE(listens());
    all.clear();
    for (int i = 0; i < 5000; ++i) {
        send("1," + QByteArray::number(i));
    }
    ASSERT_TRUE(fakes::waitUntil([this] {
        send("2");
        return !all.empty() && all.back() == "2";
    }));
    EXPECT_LT(all.size(), 5000U);
}

// REQ-DATAGRAMS-03: A port that another program uses is reported, and opening it is tried again.
TEST_F(DatagramPortTest, ATakenPortIsTriedAgain)
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
}  // namespace boresight::datagrams

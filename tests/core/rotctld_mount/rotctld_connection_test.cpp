// SPDX-License-Identifier: GPL-3.0-or-later
// The mount with a real TCP connection to Hamlib's own rotctld and rigctld, and to servers that the test controls.
#include "core/rotator_box/tcp_box_line.h"
#include "tests/core/rotctld_mount/rotctld_rig.h"
#include "tests/fakes/program.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QStandardPaths>
#include <QTcpServer>
#include <QTcpSocket>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace boresight::rotctl {
namespace {

using fakes::waitUntil;

std::unique_ptr<BoxLine> lineTo(quint16 port)
{
    return std::make_unique<TcpBoxLine>(BusName{.kind = BusKind::Rotctld, .target = "127.0.0.1", .port = port});
}

// REQ-ROTCTLDMOUNT-40: Boresight connects to the host and port of a rotctld. A connection that ends is opened again,
// and the text says what to check.
TEST(RotctldConnection, ConnectsAgain)
{
    QTcpServer server;
    ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
    Rig rig(lineTo(server.serverPort()));
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(rig.comesTrue([&] { return server.hasPendingConnections(); }));
        const std::unique_ptr<QTcpSocket> peer(server.nextPendingConnection());
        ASSERT_TRUE(rig.comesTrue([&] { return peer->bytesAvailable() > 0; }));
        EXPECT_EQ(peer->readAll(), QByteArray("+\\dump_state\n"));
        peer->close();
        EXPECT_TRUE(rig.comesTrue([&] { return rig.line().state == MountLine::State::Lost; }));
        EXPECT_TRUE(rig.warns("rotator.line-down"));
        EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("rotctld runs there")))
            << rig.line().problem.toStdString();
        EXPECT_TRUE(rig.line().problem.startsWith(QStringLiteral("rotctld:127.0.0.1:")));
    }
}

// REQ-ROTCTLDMOUNT-41: A server that is no rotctld receives one query and never a command. The connection is closed and
// not opened again.
TEST(RotctldConnection, AForeignServerIsClosedAndLeftAlone)
{
    QTcpServer server;
    ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
    Rig rig(lineTo(server.serverPort()));
    ASSERT_TRUE(rig.comesTrue([&] { return server.hasPendingConnections(); }));
    const std::unique_ptr<QTcpSocket> peer(server.nextPendingConnection());
    ASSERT_TRUE(rig.comesTrue([&] { return peer->bytesAvailable() > 0; }));
    peer->write("HTTP/1.1 400 Bad Request\r\n\r\n");
    EXPECT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.foreign"); }));
    EXPECT_FALSE(rig.control.request(request::PointAxes{{60_deg, 45_deg}}, kOperator));
    for (int i = 0; i < 500; ++i) {
        rig.tick();
    }
    EXPECT_TRUE(waitUntil([&] { return peer->state() == QAbstractSocket::UnconnectedState; }));
    EXPECT_EQ(peer->readAll(), QByteArray("+\\dump_state\n"));
    EXPECT_FALSE(server.hasPendingConnections());
}

// A server program of Hamlib from Debian, with its dummy.
class HamlibServer : public testing::Test
{
protected:
    void start(const char* name)
    {
        const QString path = QStandardPaths::findExecutable(QLatin1String(name));
        if (path.isEmpty()) {
            GTEST_SKIP() << name << " is not installed (Debian package libhamlib-utils)";
        }
        port = fakes::unusedPort();
        ASSERT_NE(port, 0);
        server = std::make_unique<fakes::Program>(
            path, QStringList{QStringLiteral("-m"), QStringLiteral("1"), QStringLiteral("-T"),
                              QStringLiteral("127.0.0.1"), QStringLiteral("-t"), QString::number(port)});
    }

    quint16 port = 0;
    std::unique_ptr<fakes::Program> server;
};

// REQ-ROTCTLDMOUNT-42: Boresight queries, moves and stops a rotator by Hamlib's own rotctld. This rotctld is ended and
// started again. After the reconnect nothing moves by itself.
TEST_F(HamlibServer, ItsRotctldIsDriven)
{
    start("rotctld");
    if (!server) {
        return;
    }
    Rig rig(lineTo(port));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.place().has_value(); }));
    EXPECT_EQ(rig.line().kind, QStringLiteral("rotctld"));
    EXPECT_EQ(rig.line().dropped, 0U);
    EXPECT_TRUE(rig.connection->driver().interlock());
    ASSERT_TRUE(rig.control.request(request::PointAxes{{20_deg, 15_deg}}, kOperator));
    EXPECT_TRUE(rig.comesTrue([&] { return abs(rig.place()->azimuth - 20_deg) < 0.1_deg; }));
    EXPECT_TRUE(rig.comesTrue([&] { return abs(rig.place()->elevation - 15_deg) < 0.1_deg; }));
    ASSERT_TRUE(rig.control.request(request::PointAxes{{200_deg, 80_deg}}, kOperator));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.place()->azimuth > 22_deg; }));
    ASSERT_TRUE(rig.control.request(request::Stop{}, kOperator));
    const auto received = rig.line().received;
    ASSERT_TRUE(rig.comesTrue([&] { return rig.line().received > received + 3; }));
    const auto stood = rig.place();
    ASSERT_TRUE(rig.comesTrue([&] { return rig.line().received > received + 6; }));
    EXPECT_EQ(rig.place(), stood) << "it stands exactly";
    EXPECT_LT(stood->azimuth, 100_deg);
    ASSERT_TRUE(rig.control.request(request::ResetStop{}, kOperator));

    server->kill();
    ASSERT_EQ(server->waitForEnd(), -1);
    ASSERT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.line-down"); }));
    server = std::make_unique<fakes::Program>(
        QStandardPaths::findExecutable(QStringLiteral("rotctld")),
        QStringList{QStringLiteral("-m"), QStringLiteral("1"), QStringLiteral("-T"), QStringLiteral("127.0.0.1"),
                    QStringLiteral("-t"), QString::number(port)});
    ASSERT_TRUE(rig.comesTrue([&] { return rig.connection->driver().answers(); }));
    const auto again = rig.line().received;
    ASSERT_TRUE(rig.comesTrue([&] { return rig.line().received > again + 5; }));
    EXPECT_EQ(rig.place(), (AxisPosition{0_deg, 0_deg})) << "the dummy begins there";
}

// REQ-ROTCTLDMOUNT-43: A rigctld, whose usual port is the next number, is recognised and never receives a command.
TEST_F(HamlibServer, ItsRigctldIsLeftAlone)
{
    start("rigctld");
    if (!server) {
        return;
    }
    Rig rig(lineTo(port));
    EXPECT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.foreign"); }));
    EXPECT_EQ(rig.line().sent, 1U);
}

}  // namespace
}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bus_name.h"
#include "core/gs232_mount/gs232_mount.h"
#include "core/rotator_box/box_connection.h"
#include "core/rotator_box/serial_box_line.h"
#include "core/rotator_box/simulated_box_line.h"
#include "core/rotator_box/tcp_box_line.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <QTcpServer>
#include <QTcpSocket>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace boresight::gs232 {
namespace {

using fakes::waitUntil;

BusName localPort(quint16 port)
{
    return {.kind = BusKind::Tcp, .target = "127.0.0.1", .port = port};
}

QByteArray collected(BoxLine& line, QObject& context, QByteArray& into)
{
    QObject::connect(&line, &BoxLine::received, &context, [&into](const QByteArray& bytes) { into += bytes; });
    return into;
}

// REQ-GS232-40: A rotator is connected by a serial port. A port that disappears is reported, and is used again when it
// is back.
TEST(SerialBoxLine, CarriesBytesAndReportsAPortThatIsGone)
{
    auto terminal = std::make_unique<fakes::PseudoTerminal>();
    SerialBoxLine line(terminal->path(), 9600);
    QObject context;
    QByteArray heard;
    collected(line, context, heard);
    line.open();
    ASSERT_EQ(line.state(), BoxLine::State::Up) << line.problem().toStdString();
    line.write("C2\r");
    EXPECT_TRUE(waitUntil([&] { return terminal->written == "C2\r"; }));
    terminal->write("AZ=180  EL=090\r\n");
    EXPECT_TRUE(waitUntil([&] { return heard == "AZ=180  EL=090\r\n"; }));
    terminal->unplug();
    EXPECT_TRUE(waitUntil([&] { return line.state() == BoxLine::State::Lost; }));
    EXPECT_TRUE(line.problem().contains(QStringLiteral("is gone")));
}

TEST(SerialBoxLine, APortThatIsNotThereHasAReason)
{
    SerialBoxLine line(QStringLiteral("/dev/does-not-exist"), 9600);
    line.open();
    EXPECT_EQ(line.state(), BoxLine::State::Lost);
    EXPECT_TRUE(line.problem().contains(QStringLiteral("does not exist")));
    line.write("C2\r");  // this write has no effect
}

// REQ-GS232-41: A port that another line has open is not shared.
TEST(SerialBoxLine, APortInUseIsLeftAlone)
{
    const fakes::PseudoTerminal terminal;
    SerialBoxLine first(terminal.path(), 9600);
    first.open();
    ASSERT_EQ(first.state(), BoxLine::State::Up);
    SerialBoxLine second(terminal.path(), 9600);
    second.open();
    EXPECT_EQ(second.state(), BoxLine::State::Lost);
    EXPECT_TRUE(second.problem().contains(QStringLiteral("in use"))) << second.problem().toStdString();
}

// REQ-GS232-42: A rotator is connected by TCP. A connection that ends is opened again.
TEST(TcpBoxLine, CarriesBytesAndConnectsAgain)
{
    QTcpServer server;
    ASSERT_TRUE(server.listen(QHostAddress::LocalHost));
    TcpBoxLine line(localPort(server.serverPort()));
    QObject context;
    QByteArray heard;
    collected(line, context, heard);
    for (int i = 0; i < 2; ++i) {
        line.open();
        ASSERT_TRUE(waitUntil([&] { return line.state() == BoxLine::State::Up && server.hasPendingConnections(); }));
        const std::unique_ptr<QTcpSocket> box(server.nextPendingConnection());
        line.write("C2\r");
        EXPECT_TRUE(waitUntil([&] { return box->bytesAvailable() == 3; }));
        heard.clear();
        box->write("+0180+0090\r\n");
        EXPECT_TRUE(waitUntil([&] { return heard == "+0180+0090\r\n"; }));
        box->close();
        EXPECT_TRUE(waitUntil([&] { return line.state() == BoxLine::State::Lost; }));
        EXPECT_TRUE(line.problem().contains(QStringLiteral("closed the connection"))) << line.problem().toStdString();
    }
}

TEST(TcpBoxLine, APortWithoutABoxHasAReason)
{
    QTcpSocket keeper;  // keeps the port without listening, so that no other program can take it meanwhile
    ASSERT_TRUE(keeper.bind(QHostAddress::LocalHost, 0, QAbstractSocket::DontShareAddress));
    TcpBoxLine line(localPort(keeper.localPort()));
    line.open();
    EXPECT_TRUE(waitUntil([&] { return line.state() == BoxLine::State::Lost; }));
    EXPECT_TRUE(line.problem().contains(line.name()));
}

// REQ-GS232-44: A line has the name that the profile uses, with an IPv6 address in brackets.
TEST(TcpBoxLine, IsNamedAsInTheProfile)
{
    for (const char* const name : {"tcp:[::1]:4001", "tcp:[fe80::1%eth0]:23", "tcp:rotator.local:4001"}) {
        const Result<BusName> bus = parseBusName(name);
        ASSERT_TRUE(bus);
        EXPECT_EQ(TcpBoxLine(*bus).name(), QLatin1String(name));
    }
}

// A line that the test controls.
class Wire final : public BoxLine
{
public:
    [[nodiscard]] QString name() const override { return QStringLiteral("serial:/dev/rotator"); }
    void open() override
    {
        ++opened;
        show(State::Up);
    }
    void close() override { show(State::Closed); }
    void write(const QByteArray& bytes) override { written += bytes; }
    void say(const QByteArray& bytes) { Q_EMIT received(bytes); }
    void breakDown() { show(State::Lost, QStringLiteral("it is gone")); }

    QByteArray written;
    int opened = 0;
};

struct Rig
{
    explicit Rig(const profile::Profile& settings = {}) : profile(settings) {}

    void run(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(0.02)) {
            clock.advance(Seconds(0.02));
            connection->driver().observe(clock.now());
            (void)connection->driver().supervise({});
            connection->send();
        }
    }
    [[nodiscard]] bool warns(const char* alarm) const
    {
        return std::ranges::any_of(
            alarms.list(), [alarm](const Alarm& one) { return one.active && one.name == QLatin1String(alarm); });
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::InForce profile;
    Wire* wire = new Wire;
    std::unique_ptr<MountConnection> connection =
        rotatorBehind<Gs232Mount>(std::unique_ptr<BoxLine>(wire), {})(profile, clock, log, alarms);
};

// REQ-GS232-43: A device that is not a GS-232 box receives queries only, never a command. The line is closed and not
// opened again.
TEST(Gs232Connection, AForeignDeviceIsClosedAndLeftAlone)
{
    Rig rig;
    rig.connection->open();
    for (int i = 0; i < 4; ++i) {
        rig.run(Seconds(0.1));
        rig.wire->say(QByteArray("\xfe\xfe\xe0\x94\x03\xfd", 6));  // sent by a radio when its dial is turned
        rig.run(Seconds(0.9));
    }
    EXPECT_TRUE(rig.warns("rotator.foreign"));
    EXPECT_EQ(rig.wire->state(), BoxLine::State::Closed);
    EXPECT_TRUE(rig.wire->written.startsWith("C2\r"));
    rig.wire->written.replace("C2\r", "");
    EXPECT_EQ(rig.wire->written, QByteArray());
    rig.connection->open();
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.wire->opened, 1);
    EXPECT_EQ(rig.wire->written, QByteArray());
}

// REQ-GS232-08
TEST(Gs232Connection, AByteOfNoiseClosesNoLine)
{
    Rig rig;
    rig.connection->open();
    rig.run(Seconds(0.1));
    rig.wire->say("\xff");
    rig.run(Seconds(10.0));
    EXPECT_EQ(rig.wire->state(), BoxLine::State::Up);
    EXPECT_FALSE(rig.warns("rotator.foreign"));
    rig.wire->say("+0010+0020\r\n");
    rig.run(Seconds(0.1));
    StationStatus status;
    rig.connection->describe(status);
    EXPECT_EQ(status.line.kind, QStringLiteral("GS-232A"));
}

// REQ-GS232-86
TEST(Gs232Connection, ReportsTheCalibrationOfAnEsp32)
{
    Rig rig;
    rig.connection->open();
    rig.run(Seconds(0.1));
    rig.wire->say("RPRT -1\r");
    rig.run(Seconds(0.1));
    rig.wire->say("VEAdamESP32v1.0\rDEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:3 G:2 A:1 M:0]\r\n");
    StationStatus status;
    rig.connection->describe(status);
    EXPECT_EQ(status.line.kind, QStringLiteral("ESP32"));
    EXPECT_TRUE(status.line.condition.contains(QStringLiteral("gyroscope 2"))) << status.line.condition.toStdString();
}

// REQ-GS232-96: The status has the typed lines with their answers, and the log has both.
TEST(Gs232Connection, ShowsAndLogsTheAnswerToATypedLine)
{
    Rig rig;
    rig.connection->open();
    rig.run(Seconds(0.1));
    rig.wire->say("+0010+0020\r\n");
    rig.run(Seconds(0.1));
    EXPECT_FALSE(rig.connection->admits(request::TypeLine{"M100"}));
    ASSERT_TRUE(rig.connection->admits(request::TypeLine{"H"}));
    ASSERT_TRUE(rig.connection->carryOut(request::TypeLine{"H"}));
    rig.wire->written.clear();
    rig.run(Seconds(0.3));
    EXPECT_TRUE(rig.wire->written.endsWith("H\r")) << rig.wire->written.toStdString();
    rig.wire->say("help\r\n");
    rig.run(Seconds(1.0));
    StationStatus status;
    rig.connection->describe(status);
    EXPECT_EQ(status.console, QStringList({QStringLiteral("> H"), QStringLiteral("help")}));
    EXPECT_TRUE(rig.log.since(0, 1).back().text.contains(QStringLiteral("help")));
}

// REQ-GS232-61: The status, the diagnostics and the window show how often each motor was started, and the coast.
TEST(Gs232Connection, ReportsTheMotorStartsOfItsAxes)
{
    profile::Profile profile;
    StationStatus status;
    Rig{profile}.connection->describe(status);
    EXPECT_FALSE(status.azimuth.starts) << "nobody says that its motors are only switched";
    profile.rotator.rareStarts = profile::RareStarts::On;
    Rig{profile}.connection->describe(status);
    EXPECT_EQ(status.azimuth.starts, MotorStarts{});
    EXPECT_EQ(status.elevation.starts, MotorStarts{});
}

TEST(Gs232Connection, ALineThatIsGoneIsAnAlarmAndNotACommand)
{
    Rig rig;
    rig.connection->open();
    rig.run(Seconds(0.5));
    rig.wire->say("+0010+0020\r\n");
    rig.run(Seconds(0.5));
    StationStatus status;
    rig.connection->describe(status);
    EXPECT_EQ(status.line.kind, QStringLiteral("GS-232A"));
    rig.wire->breakDown();
    EXPECT_TRUE(rig.warns("rotator.line-down"));
    rig.wire->written.clear();
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.wire->written, QByteArray());
    rig.connection->open();
    EXPECT_FALSE(rig.warns("rotator.line-down"));
}

}  // namespace
}  // namespace boresight::gs232

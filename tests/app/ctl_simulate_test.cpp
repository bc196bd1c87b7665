// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated pair as a separate device, found by `scan` and driven by boresightd. The true motion of the axes comes
// from the device's --print-truth, not from the reports of the drives.
#include "core/mqtt/broker_client.h"
#include "core/orientation_stream/mqtt_source.h"
#include "core/orientation_stream/serial_source.h"
#include "tests/fakes/mqtt_broker.h"
#include "tests/fakes/program.h"
#include "tests/fakes/real_mount.h"
#include "tests/fakes/wait_until.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight {
namespace {

using testing::HasSubstr;

struct Truth
{
    double time = 0.0;
    double azimuth = 0.0;
    double azimuthRate = 0.0;
    int azimuthMode = -1;
};

constexpr int kPositionMode = 10;

double number(const QString& line, const char* key)
{
    const QRegularExpression pattern(QStringLiteral("\\b%1=(\\S+)").arg(QLatin1String(key)));
    return pattern.match(line).captured(1).toDouble();
}

class SimulateTest : public testing::Test
{
protected:
    void start(const QStringList& more = {})
    {
        QStringList arguments{QStringLiteral("simulate"), QStringLiteral("--pty"), device};
        m_device = std::make_unique<fakes::Program>(QStringLiteral(BORESIGHTCTL), arguments + more);
        ASSERT_TRUE(m_device->waitForLine(QStringLiteral("ready"))) << m_device->errors().toStdString();
    }

    void scan()
    {
        fakes::Program program(QStringLiteral(BORESIGHTCTL), {QStringLiteral("scan"), bus()});
        scanStatus = program.waitForEnd();
        scanned = (program.output() + program.errors()).toStdString();
    }

    [[nodiscard]] QString bus() const { return QStringLiteral("fdcanusb:") + device; }

    [[nodiscard]] std::vector<Truth> truths() const
    {
        std::vector<Truth> all;
        for (const QString& line : m_device->lines()) {
            if (line.startsWith(QStringLiteral("t="))) {
                all.push_back({.time = number(line, "t"),
                               .azimuth = number(line, "az"),
                               .azimuthRate = number(line, "az_rate"),
                               .azimuthMode = static_cast<int>(number(line, "az_mode"))});
            }
        }
        return all;
    }

    // Waits for a line of truth with this property. Returns nothing if none comes.
    [[nodiscard]] std::optional<Truth> waitForTruth(const std::function<bool(const Truth&)>& condition) const
    {
        const bool came = fakes::waitUntil([&] {
            const std::vector<Truth> all = truths();
            if (!all.empty()) {
                m_startOfTruth = std::min(m_startOfTruth, seconds() - all.back().time);
            }
            return !all.empty() && condition(all.back());
        });
        return came ? std::optional(truths().back()) : std::nullopt;
    }

    // How late a line is read after its time: a busy computer delays lines.
    [[nodiscard]] double lateness(const Truth& line) const { return seconds() - line.time - m_startOfTruth; }
    [[nodiscard]] double seconds() const { return 1.0e-3 * static_cast<double>(m_clock.elapsed()); }

    // The longest time between two lines, a tenth of a second on an idle computer. Frames that arrived meanwhile count
    // as new.
    [[nodiscard]] double longestPause() const
    {
        const std::vector<Truth> all = truths();
        double longest = 0.0;
        for (std::size_t i = 1; i < all.size(); ++i) {
            longest = std::max(longest, all[i].time - all[i - 1].time);
        }
        return longest;
    }

    QTemporaryDir folder;
    QString device = folder.filePath(QStringLiteral("mount"));
    std::unique_ptr<fakes::Program> m_device;
    int scanStatus = -1;
    std::string scanned;
    QElapsedTimer m_clock = [] {
        QElapsedTimer clock;
        clock.start();
        return clock;
    }();
    // start of the device's clock on the clock of the test, computed from the fastest line
    mutable double m_startOfTruth = std::numeric_limits<double>::infinity();
};

// REQ-CTL-307
TEST_F(SimulateTest, IsFoundByScanAgainAndAgain)
{
    start({QStringLiteral("--el-id=9")});
    for (int round = 0; round < 2; ++round) {
        scan();
        EXPECT_EQ(scanStatus, 0) << scanned;
        EXPECT_TRUE(scanned.starts_with("The boards are simulated. No real drive answers.\nid  UUID")) << scanned;
        EXPECT_THAT(scanned, HasSubstr("\n1   626f7265-7369-6768-7420-73696d203031"));
        EXPECT_THAT(scanned, HasSubstr("\n9   626f7265-7369-6768-7420-73696d203032"));
    }
}

TEST_F(SimulateTest, EndsCleanlyAndTakesItsLinkAway)
{
    start();
    EXPECT_TRUE(QFileInfo(device).isSymLink());
    m_device->terminate();
    EXPECT_EQ(m_device->waitForEnd(), 0);
    EXPECT_FALSE(QFileInfo(device).isSymLink());
}

// The station reads the simulated sensor on a real port.
TEST_F(SimulateTest, IsItsOrientationSensorToo)
{
    const QString port = folder.filePath(QStringLiteral("sensor"));
    start({QStringLiteral("--sensor"), port});
    EXPECT_TRUE(m_device->lines().front().startsWith(QStringLiteral("sensor /dev/pts/")));
    const SystemClock clock;
    orientation::SerialSource source({.port = port}, clock);
    std::optional<orientation::Orientation> heard;
    QObject::connect(&source, &orientation::SensorSource::received, &source,
                     [&](const orientation::Orientation& value) { heard = value; });
    source.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return heard.has_value(); })) << source.status().problem.toStdString();
    EXPECT_NEAR(heard->elevation.degrees(), 10.0, 2.0);
    EXPECT_EQ(heard->calibration->magnetometer, 3);
    source.close();
    m_device->terminate();
    EXPECT_EQ(m_device->waitForEnd(), 0);
    EXPECT_FALSE(QFileInfo(port).isSymLink());
}

// The sensor publishes at its device and at a broker at the same time, like the sensor box on the boom.
// REQ-SIM-16
TEST_F(SimulateTest, ItsSensorPublishesAtABrokerAsWell)
{
    if (!fakes::MqttBroker::isInstalled()) {
        GTEST_SKIP() << "no mosquitto (Debian package mosquitto)";
    }
    fakes::MqttBroker broker;
    ASSERT_TRUE(broker.start());
    const SystemClock clock;
    mqtt::BrokerClient client(clock);
    orientation::MqttSource source(client, {.orientation = QStringLiteral("roof/orientation")}, clock);
    std::vector<orientation::Orientation> heard;
    QObject::connect(&source, &orientation::SensorSource::received, &source,
                     [&](const orientation::Orientation& value) { heard.push_back(value); });
    source.open();
    client.open({.host = QStringLiteral("127.0.0.1"), .port = broker.port()});
    const QString address = QStringLiteral("127.0.0.1:%1").arg(broker.port());
    start({QStringLiteral("--sensor-mqtt"), address, QStringLiteral("--sensor-topics"), QStringLiteral("roof/"),
           QStringLiteral("--sensor"), folder.filePath(QStringLiteral("sensor")), QStringLiteral("--sensor-north"),
           QStringLiteral("-12"), QStringLiteral("--sensor-tilt"), QStringLiteral("0,0"),
           QStringLiteral("--sensor-deviation"), QStringLiteral("0,0,0,0"), QStringLiteral("--sensor-frozen"),
           QStringLiteral("@2")});
    ASSERT_TRUE(fakes::waitUntil([&] { return heard.size() >= 4; })) << source.status().problem.toStdString();
    EXPECT_NEAR(heard.back().heading.angle().degrees(), 348.0, 2.0) << "noise, collimation and backlash are left";
    EXPECT_NEAR(heard.back().elevation.degrees(), 10.0, 2.0);
    EXPECT_EQ(heard[3].heading, heard[2].heading) << "frozen, for it is not without noise";
    EXPECT_THAT(m_device->errors().toStdString(), HasSubstr("s: the sensor publishes on roof/\n"));
    EXPECT_THAT(m_device->errors().toStdString(), HasSubstr("begins: the sensor repeats one value\n"));
    m_device->terminate();
    EXPECT_EQ(m_device->waitForEnd(), 0);
}

TEST_F(SimulateTest, ABrokerThatTakesNobodyIsOneLineHoweverOftenItIsTried)
{
    QTcpServer nobody;
    ASSERT_TRUE(nobody.listen(QHostAddress::LocalHost));
    int attempts = 0;
    QObject::connect(&nobody, &QTcpServer::newConnection, &nobody, [&] {
        ++attempts;
        delete nobody.nextPendingConnection();
    });
    const QString address = QStringLiteral("127.0.0.1:%1").arg(nobody.serverPort());
    start({QStringLiteral("--sensor-mqtt"), address});
    ASSERT_TRUE(fakes::waitUntil([&] { return attempts == 3; }));  // two of them have failed by then
    EXPECT_EQ(m_device->errors().count(QStringLiteral("MQTT broker ") + address), 1)
        << m_device->errors().toStdString();
}

// Story: the simulation was tried near the mast, at the broker of the real sensor, and the real mount received both
// sensors.
TEST(SimulateHelp, WarnsOfTheRealSensorsTopics)
{
    fakes::Program program(QStringLiteral(BORESIGHTCTL), {QStringLiteral("help"), QStringLiteral("simulate")});
    EXPECT_EQ(program.waitForEnd(), 0);
    const std::string help = program.output().simplified().toStdString();
    EXPECT_THAT(help,
                HasSubstr("every program that reads them at this broker uses the simulated sensor. To separate the "
                          "two, add --sensor-topics simulated/"));
}

TEST_F(SimulateTest, FailsWhereNoLinkCanBeMade)
{
    device = folder.filePath(QStringLiteral("absent/mount"));
    fakes::Program program(QStringLiteral(BORESIGHTCTL), {QStringLiteral("simulate"), QStringLiteral("--pty"), device});
    EXPECT_EQ(program.waitForEnd(), 1);
    EXPECT_EQ(program.output(), QString());
    EXPECT_THAT(program.errors().toStdString(), HasSubstr("absent/mount"));
}

TEST_F(SimulateTest, BoardsFreshFromTheBoxAreSaidToShareAnId)
{
    start({QStringLiteral("--factory")});
    scan();
    EXPECT_EQ(scanStatus, 1);
    EXPECT_THAT(scanned, HasSubstr("id 1: a controller replies, but its UUID never arrives complete"));
    EXPECT_THAT(scanned, HasSubstr("Probably two controllers have this id"));
}

TEST_F(SimulateTest, InjectedFaultsAreAnnouncedAndSeenByScan)
{
    start({QStringLiteral("--register-map"), QStringLiteral("az:4"), QStringLiteral("--fault"),
           QStringLiteral("el:38@50ms"), QStringLiteral("--late"), QStringLiteral("20ms+100ms")});
    ASSERT_TRUE(fakes::waitUntil([&] { return m_device->errors().contains(QStringLiteral("ends:")); }));
    EXPECT_THAT(m_device->errors().toStdString(),
                HasSubstr("s: begins: elevation: drive fault 38, over temperature\n"));
    EXPECT_THAT(m_device->errors().toStdString(), HasSubstr("s: ends: both axes: replies 0.02 s late\n"));
    // A scan on a busy computer may miss replies, and says so.
    EXPECT_TRUE(fakes::waitUntil([&] {
        scan();
        return !QString::fromStdString(scanned).contains(QStringLiteral("got no reply"));
    }));
    EXPECT_EQ(scanStatus, 1);
    EXPECT_THAT(scanned, HasSubstr("id 1: register map version 4 is unknown. Boresight supports version 5."));
    EXPECT_THAT(scanned, HasSubstr("id 2: fault 38, over temperature"));
}

TEST_F(SimulateTest, SilenceTellsWhatToCheck)
{
    start({QStringLiteral("--silence")});
    scan();
    EXPECT_EQ(scanStatus, 1);
    EXPECT_THAT(scanned, HasSubstr("no controller replied on fdcanusb:"));
}

TEST_F(SimulateTest, AnAdapterThatRefusesIsNamedAsTheCause)
{
    start({QStringLiteral("--adapter-error")});
    scan();
    for (int i = 0; i < 5 && scanned.find("no OK within") != std::string::npos; ++i) {
        scan();  // on a busy computer the adapter's answer came too late
    }
    EXPECT_EQ(scanStatus, 1);
    EXPECT_THAT(scanned, HasSubstr("the adapter refuses a frame: invalid data"));
}

TEST_F(SimulateTest, TimeGoesOnWithoutAnybodyAsking)
{
    start({QStringLiteral("--print-truth"), QStringLiteral("--wind"), QStringLiteral("az:30+300ms")});
    EXPECT_TRUE(waitForTruth([](const Truth& now) { return now.azimuth > 0.1; })) << "the wind turns a free axis";
}

// The complete chain: Hamlib's client, the service, the adapter, the drives. The service is killed during a motion at
// full speed. Then only the watchdog of the drives can stop the axis.
TEST_F(SimulateTest, AxisStopsWhenTheServiceIsKilledInMotion)
{
    const QString rotctl = QStandardPaths::findExecutable(QStringLiteral("rotctl"));
    if (rotctl.isEmpty()) {
        GTEST_SKIP() << "rotctl is not installed (Debian: libhamlib-utils)";
    }
    start({QStringLiteral("--print-truth")});
    fakes::Program service(QStringLiteral(BORESIGHTD),
                           QStringList{QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0"),
                                       QStringLiteral("--state-dir"), folder.path()} +
                               fakes::confirmedMount(folder.path(), bus()) + fakes::standingAt(QStringLiteral("0,10")));
    const QString listening = QStringLiteral("rotctld listening on ");
    ASSERT_TRUE(service.waitForLine(listening)) << service.errors().toStdString();
    ASSERT_TRUE(fakes::waitUntil([&] { return service.errors().contains(QStringLiteral("every drive answers")); }));
    const QString address = service.lines().constLast().mid(listening.size());

    const auto ask = [&](const QStringList& command) {
        fakes::Program client(
            rotctl, QStringList{QStringLiteral("-m"), QStringLiteral("2"), QStringLiteral("-r"), address} + command);
        return client.waitForEnd();
    };
    double target = 170.0;
    const auto go = [&] { return ask({QStringLiteral("P"), QString::number(target), QStringLiteral("45")}); };
    // If a busy computer ran neither program for longer than the watchdog time of the drives, they have stopped,
    // perhaps before the first command, which is then refused. They are re-armed and commanded again. And the whole
    // motion may be over before the client has ended. Then the axis is sent on.
    const auto moving = waitForTruth([&](const Truth& now) {
        if (now.azimuthMode != kPositionMode && go() != 0) {
            static_cast<void>(ask({QStringLiteral("R"), QStringLiteral("1")}));
        } else if (now.azimuthMode == kPositionMode && now.azimuth > target - 1.0 && target < 400.0) {
            target += 130.0;
            static_cast<void>(go());
        }
        return now.azimuth > 10.0 && now.azimuthRate > 8.0;
    });
    ASSERT_TRUE(moving) << "the axis never moved";
    service.kill();
    EXPECT_EQ(service.waitForEnd(), -1);
    // The service may have sent commands until it was killed, and a device that did not run reads the last commands
    // later. So delays of a busy computer must not count as a longer motion.
    const double gone = lateness(*moving);
    const auto still =
        waitForTruth([&](const Truth& now) { return now.time > moving->time + gone + 0.25 + longestPause(); });
    ASSERT_TRUE(still);
    const double allowed = gone + 0.2 + longestPause();
    EXPECT_LT(still->azimuth - moving->azimuth, allowed * moving->azimuthRate) << "degrees run on";
    // The axis still settles within its backlash: measured 0.2°/s and 0.04° back.
    EXPECT_LT(std::abs(still->azimuthRate), 0.05 * moving->azimuthRate);
    const auto later = waitForTruth([&](const Truth& now) { return now.time > still->time + 1.0; });
    ASSERT_TRUE(later);
    EXPECT_NEAR(later->azimuth, still->azimuth, 0.05);
    EXPECT_NE(later->azimuthMode, kPositionMode);
}

}  // namespace
}  // namespace boresight

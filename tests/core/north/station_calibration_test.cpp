// SPDX-License-Identifier: GPL-3.0-or-later
// The complete system: the simulated mount with its own sensor, and the station that calibrates it.
#include "core/calibration/fit_words.h"
#include "core/ephemeris/almanac.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_sensor/simulated_source.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QTemporaryDir>
#include <QUdpSocket>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace boresight {
namespace {

profile::Profile withSensor()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.sensor.source = profile::SensorSource::Simulated;
    return profile;
}

class CalibratedStation
{
public:
    explicit CalibratedStation(const profile::Profile& profile = withSensor())
        : m_mount(std::make_shared<SimulatedMount>(clock, sim::commissionedPair()))
    {
        auto owned = std::make_unique<SimulatedLink>(clock, m_mount);
        m_link = owned.get();
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(owned), {folder.path(), simulationOf(Simulation::Off, profile)}),
            folder.path(), clock);
        station->setSensorMaker([this](const profile::Profile& wanted, mqtt::Connection& broker) {
            auto made = sensorMaker(clock, m_mount)(wanted, broker);
            m_source = dynamic_cast<SimulatedSource*>(made.get());
            return made;
        });
        QObject::connect(station.get(), &Station::profileApplied,
                         [this](const profile::Profile& applied) { saved = applied; });
        QObject::connect(station.get(), &Station::updated, [this](const StationUpdate& update) {
            for (const Answer& answer : update.answers) {
                m_error = answer.error;
            }
            log.insert(log.end(), update.log.begin(), update.log.end());
        });
        station->openAll();
        run(Seconds(5.0));  // until the drive check is done
    }

    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / Seconds(0.02)); ++i) {
            clock.advance(Seconds(0.02));
            m_link->deliver();
            station->tick();
            if (++m_ticks % 10 == 0 && m_source != nullptr) {
                m_source->read();
            }
        }
    }

    Result<> ask(const Request& request)
    {
        m_error.reset();
        station->request({.id = 1, .request = request});
        station->updateTaken();
        station->publish();
        run(Seconds(0.1));
        return m_error ? Result<>(tl::unexpected(*m_error)) : Result<>{};
    }

    [[nodiscard]] std::shared_ptr<const CalibrationStatus> calibration() const { return station->status().calibration; }
    [[nodiscard]] bool isWarned(const QString& what) const
    {
        return std::ranges::any_of(station->status().alarms,
                                   [&](const Alarm& alarm) { return alarm.what.startsWith(what) && alarm.active; });
    }
    [[nodiscard]] QString file() const
    {
        return calibrationPath(folder.path(), toQString(station->status().profile->mount.name), true);
    }
    [[nodiscard]] QString motionsLogged()
    {
        EXPECT_TRUE(ask(request::TakeAuthority{}));
        QStringList lines;
        for (const LogEntry& line : log) {
            lines << (line.kind == LogKind::MotionStart ? line.text : QString());
        }
        return lines.join(QLatin1Char('\n'));
    }
    [[nodiscard]] sim::SensorTruth& truth() { return m_mount->sensor.truth(); }

    QTemporaryDir folder;
    fakes::ManualClock clock;
    std::unique_ptr<Station> station;
    std::optional<profile::Profile> saved;
    std::vector<LogEntry> log;  // the entries fetched so far

private:
    std::shared_ptr<SimulatedMount> m_mount;
    SimulatedLink* m_link = nullptr;
    SimulatedSource* m_source = nullptr;
    int m_ticks = 0;
    std::optional<Error> m_error;
};

// REQ-CONTROL-406: Once the site is set, the status has the positions of Sun and Moon, also below the horizon.
TEST(BodiesInTheStatus, AreThereOnceTheSiteIsSet)
{
    CalibratedStation rig;
    EXPECT_TRUE(rig.station->status().bodies.empty());
    profile::Profile profile = withSensor();
    profile.site = {.known = true, .latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0};
    ASSERT_TRUE(rig.ask(request::ApplyProfile{profile}));
    rig.run(Seconds(1.0));
    const StationStatus status = rig.station->status();
    ASSERT_EQ(status.bodies.size(), 2U);
    ephemeris::Almanac almanac({.latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0});
    for (const BodyPlace& body : status.bodies) {
        const SkyPointing truth = almanac.place(body.body, status.utc).direction;
        EXPECT_NEAR((body.direction.azimuth - truth.azimuth).wrapped180().degrees(), 0.0, 0.05);
        EXPECT_NEAR(body.direction.elevation.degrees(), truth.elevation.degrees(), 0.7) << "bent by the air";
    }
    EXPECT_NE(status.bodies[0].body, status.bodies[1].body);
}

class SwingAtEveryRate : public ::testing::TestWithParam<double>
{};

// Drives with physics, and a sensor that averages. Story: a limit of 3 A is below what such a mount draws when it
// turns. At every rate a fifth of the readings was discarded.
// REQ-NORTH-36a
// REQ-CALIBRATION-04
TEST_P(SwingAtEveryRate, UsesItsReadings)
{
    const double rate = GetParam();
    // the slowest rate takes long, and needs less arc for enough readings
    const double arc = rate < 1.0 ? 240.0 : 360.0;
    profile::Profile profile = withSensor();
    profile.limits.azimuth = {.min = -1_deg, .max = Angle::fromDegrees(arc + 1.0)};
    CalibratedStation rig(profile);
    rig.truth().noise = 0.5_deg;
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}));
    rig.run(Seconds(30.0));
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = AngularRate::fromDegrees(rate), .headings = 0}));
    rig.run(Seconds(90.0 + 2.0 * arc / rate));
    const auto swing = rig.calibration()->swing;
    ASSERT_TRUE(swing) << rig.calibration()->progress.outcome.toStdString();
    const calibration::SwingTally tally(swing->fit.samples);
    EXPECT_GT(tally.all(), 100U);
    EXPECT_LE(static_cast<double>(tally.leftOut()), 0.1 * static_cast<double>(tally.all()))
        << rig.calibration()->progress.outcome.toStdString();
}

INSTANTIATE_TEST_SUITE_P(Offered, SwingAtEveryRate, ::testing::Values(0.5, 3.0, 6.0));

// Story: the bus of the real mount waited for its reconnect. Apply saved the north of the simulated mount together with
// that bus.
// REQ-PROFILE-17a
TEST(StationCalibration, TheSimulatedMountDoesNotTakeTheBusOfARealOne)
{
    CalibratedStation rig;
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::ProposeTerms{{.azimuthOffset = 37.4_deg}}));
    profile::Profile real = *rig.station->status().profile;
    real.bus = "socketcan:can0";
    real.sensor.source = profile::SensorSource::None;
    const auto refused = rig.ask(request::ApplyProfile{real});
    ASSERT_FALSE(refused);
    EXPECT_EQ(textOf(refused.error()),
              "The bus cannot change between simulated and real while the mount is connected. Press Reconnect, or "
              "restart Boresight.");
    EXPECT_FALSE(rig.saved);
    EXPECT_TRUE(rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}));
    EXPECT_EQ(rig.saved->bus, "simulated");
}

// REQ-NORTH-38f
TEST(StationCalibration, WhatIsFoundIsNotAppliedForAMountThatWaitsForItsReconnect)
{
    profile::Profile inForce = withSensor();
    inForce.sensor.source = profile::SensorSource::None;
    inForce.bus = "socketcan:can0";
    CalibratedStation rig(inForce);
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::ProposeTerms{{.azimuthOffset = 37.4_deg}}));
    profile::Profile other = inForce;
    other.bus = "socketcan:can1";
    ASSERT_TRUE(rig.ask(request::ApplyProfile{other}));
    const auto refused = rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number});
    ASSERT_FALSE(refused);
    EXPECT_EQ(textOf(refused.error()),
              "This calibration belongs to the mount at socketcan:can0, but the bus of the profile is now "
              "socketcan:can1. Set the bus back, or press Reconnect and calibrate again.");
    EXPECT_EQ(*rig.saved, other);
    other.bus = "socketcan:can0";
    ASSERT_TRUE(rig.ask(request::ApplyProfile{other}));
    EXPECT_TRUE(rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}));
}

// REQ-CALIBRATION-35: The log names each motion of a swing as a swing.
TEST(StationCalibration, ASwingOfTheSimulatedMountFindsItsHiddenNorth)
{
    CalibratedStation rig;
    rig.truth().mount.azimuthOffset = 37.4_deg;
    rig.truth().mount.tiltNorth = 0.6_deg;
    rig.truth().a1 = 8_deg;
    rig.truth().b2 = 3_deg;
    rig.truth().noise = 0.5_deg;
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}));
    rig.run(Seconds(30.0));
    const auto started = rig.ask(request::StartSwing{.rate = 5_deg_s, .headings = 0});
    ASSERT_TRUE(started) << textOf(started.error());
    rig.run(Seconds(60.0));
    EXPECT_EQ(StationState::Calibrate, rig.station->status().state);
    rig.run(Seconds(150.0));
    ASSERT_TRUE(rig.calibration()->proposal) << rig.calibration()->progress.outcome.toStdString();
    EXPECT_EQ(StationState::Hold, rig.station->status().state);
    const QString motions = rig.motionsLogged();
    EXPECT_TRUE(motions.contains(QStringLiteral("compass swing, to its start (axes ")));
    EXPECT_TRUE(motions.contains(QStringLiteral("compass swing, turning clockwise")));
    EXPECT_TRUE(motions.contains(QStringLiteral("compass swing, turning counter-clockwise")));
    EXPECT_FALSE(motions.contains(QStringLiteral(": move"))) << motions.toStdString();

    const AxisPosition before{*rig.station->status().azimuth.actual, *rig.station->status().elevation.actual};
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}));
    ASSERT_TRUE(rig.saved);
    EXPECT_EQ(*rig.saved, *rig.station->status().profile);
    EXPECT_NEAR(37.4, rig.saved->pointing.azimuthOffset.degrees(), 2.0);
    EXPECT_NEAR(0.6, rig.saved->pointing.tiltNorth.degrees(), 0.2);
    rig.run(Seconds(5.0));
    EXPECT_NEAR(before.azimuth.degrees(), rig.station->status().azimuth.actual->degrees(), 0.01);
    EXPECT_NEAR(before.elevation.degrees(), rig.station->status().elevation.actual->degrees(), 0.01);
    // The sensor is corrected and agrees with the axes all around.
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 250_deg, .elevation = 40_deg}}));
    rig.run(Seconds(60.0));
    ASSERT_TRUE(rig.station->status().sensor.azimuthDifference);
    EXPECT_LT(abs(*rig.station->status().sensor.azimuthDifference), 2.5_deg);
    EXPECT_EQ(1, QDir(rig.folder.path()).entryList({QStringLiteral("*.calibrations.toml")}).size());

    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(withSensor(), *rig.saved);
}

// Scenario: a mast of steel beside the antenna. Its edges lie between the steps in which a swing marks a sector.
// REQ-WITNESS-41a
// REQ-NORTH-963
TEST(StationCalibration, BesideSteelTheSensorIsSilentAfterASwingAndGivesNoNorth)
{
    profile::Profile profile = withSensor();
    profile.sensor.stillCurrent = 5.0;  // a motor holds the boom
    CalibratedStation rig(profile);
    rig.truth().mount.azimuthOffset = 37.4_deg;
    rig.truth().a1 = 8_deg;
    rig.truth().noise = 0.5_deg;
    rig.truth().steelFrom = 203_deg;
    rig.truth().steelTo = 232_deg;
    rig.truth().steel = 15_deg;
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}));
    rig.run(Seconds(30.0));
    ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 5_deg_s, .headings = 0}));
    rig.run(Seconds(210.0));
    ASSERT_TRUE(rig.calibration()->proposal) << rig.calibration()->progress.outcome.toStdString();
    const std::vector<QString> warned = rig.calibration()->proposal->warnings;
    const QString warnings = QStringList(warned.begin(), warned.end()).join(QLatin1Char('\n'));
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}));
    const Angle north = rig.saved->pointing.azimuthOffset;
    // Story: the warning had the headings from magnetic north, and the sector those from true north.
    ASSERT_EQ(rig.saved->sensor.deviation.unreliable.size(), 1U);
    const profile::UnreliableArc sector = rig.saved->sensor.deviation.unreliable.front();
    EXPECT_TRUE(warnings.contains(QStringLiteral("From %1 to %2 the compass is off by 15°.")
                                      .arg(calibration::inWords(sector.from, 0), calibration::inWords(sector.to, 0))))
        << warnings.toStdString();
    for (double beam = 196.0; beam <= 240.0; beam += 2.0) {
        ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = Angle::fromDegrees(beam) - 37.4_deg, .elevation = 30_deg}}));
        rig.run(Seconds(8.0));
        EXPECT_FALSE(rig.isWarned(QStringLiteral("The orientation sensor and the axes differ"))) << beam;
    }
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 224_deg - 37.4_deg, .elevation = 30_deg}}));
    rig.run(Seconds(20.0));
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    rig.run(Seconds(30.0));
    ASSERT_TRUE(rig.calibration()->proposal) << rig.calibration()->progress.outcome.toStdString();
    const std::uint64_t number = rig.calibration()->proposal->number;
    EXPECT_FALSE(rig.ask(request::ApplyCalibration{number}));
    EXPECT_EQ(rig.saved->pointing.azimuthOffset, north);
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{.proposal = number, .overridesDoubts = true}));
    EXPECT_NEAR((rig.saved->pointing.azimuthOffset - north).degrees(), 15.0, 2.0);
}

const QString kNotWritten = QStringLiteral("The history of the calibration is not stored");

Result<> applyNorth(CalibratedStation& rig, Angle north)
{
    const auto proposed = rig.ask(request::ProposeTerms{{.azimuthOffset = north}});
    return proposed ? rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}) : proposed;
}

// Story: only the list of the history said so, and after a restart nothing could be undone.
// REQ-NORTH-38b
TEST(StationCalibration, AHistoryThatIsNotWrittenIsAnAlarm)
{
    CalibratedStation rig;
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.isWarned(kNotWritten));
    ASSERT_TRUE(QDir().mkpath(rig.file()));  // nobody can overwrite a folder, not even root
    ASSERT_TRUE(applyNorth(rig, 12_deg));
    ASSERT_TRUE(fakes::waitUntil([&] {
        rig.run(Seconds(0.3));
        return rig.isWarned(kNotWritten);
    }));
    EXPECT_EQ(12_deg, rig.saved->pointing.azimuthOffset) << "in force all the same";
    ASSERT_TRUE(QDir().rmdir(rig.file()));
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_TRUE(fakes::waitUntil([&] {
        rig.run(Seconds(0.3));
        return !rig.isWarned(kNotWritten);
    }));
}

TEST(StationCalibration, NoSensorIsSaidAndRefused)
{
    CalibratedStation rig;
    profile::Profile without = withSensor();
    without.sensor.source = profile::SensorSource::None;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{without}));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    const auto refused = rig.ask(request::StartSwing{});
    ASSERT_FALSE(refused);
    EXPECT_EQ(ErrorCode::NotAvailable, refused.error().code);
    EXPECT_FALSE(rig.calibration()->swingPlan.obstacle.isEmpty());
}

// A mast in Vienna whose north is known to a degree or two, and a receiver that reports its power by UDP.
profile::Profile withReceiver(std::uint16_t port)
{
    profile::Profile profile = withSensor();
    profile.site = {.known = true, .latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0};
    profile.pointing.azimuthOffset = 36_deg;
    profile.power = {.source = profile::PowerSource::Udp, .host = "127.0.0.1", .port = port};
    return profile;
}

class Receiver
{
public:
    Receiver(CalibratedStation& rig, std::uint16_t port, const pointing::PointingTerms& truth)
        : m_rig(rig), m_port(port), m_truth(truth)
    {
        QObject::connect(rig.station->findChild<StationPower*>(), &StationPower::received, &m_socket,
                         [this] { ++m_arrived; });
    }

    // Sends one line. Returns when the station has read it.
    void tell(const QByteArray& line)
    {
        ASSERT_TRUE(fakes::waitUntil([this] { return m_rig.station->findChild<power::ThreadedLine*>()->isOpen(); }));
        const int before = m_arrived;
        ASSERT_EQ(line.size(), m_socket.writeDatagram(line, QHostAddress::LocalHost, m_port));
        ASSERT_TRUE(fakes::waitUntil([&] { return m_arrived > before; }));
    }
    // A Gaussian beam of 6 degrees, 20 dB above the noise, reported to a tenth of a dB.
    void tellPower(const SkyPointing& source)
    {
        const StationStatus status = m_rig.station->status();
        const SkyPointing beam = m_truth.toSky({*status.azimuth.actual, *status.elevation.actual});
        const double across =
            (beam.azimuth - source.azimuth).wrapped180().degrees() * std::cos(source.elevation.radians());
        const double off = std::hypot(across, (beam.elevation - source.elevation).degrees()) / 6.0;
        const double power = 1e-6 * std::exp2(-4.0 * off * off) + 1e-8;
        const double noise = std::normal_distribution<double>(0.0, 0.1)(m_random);
        tell("LEVEL " + QByteArray::number(10.0 * std::log10(power) + noise, 'f', 1) + " dBm\n");
    }
    [[nodiscard]] SkyPointing beam() const
    {
        const StationStatus status = m_rig.station->status();
        return m_truth.toSky({*status.azimuth.actual, *status.elevation.actual});
    }
    [[nodiscard]] const pointing::PointingModel& truth() const { return m_truth; }

private:
    CalibratedStation& m_rig;
    std::uint16_t m_port;
    pointing::PointingModel m_truth;
    QUdpSocket m_socket;
    int m_arrived = 0;
    std::mt19937_64 m_random{20261122};
};

// Scans the Sun on a summer's morning.
void scanTheSun(CalibratedStation& rig)
{
    const UtcTime morning = std::chrono::sys_days{std::chrono::year{2026} / 6 / 21} + std::chrono::hours(8);
    rig.clock.stepUtc(Seconds(morning - rig.clock.utc()));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::FollowBody{.body = ephemeris::Body::Sun}));
    rig.run(Seconds(30.0));
    const auto started = rig.ask(request::StartCrossScan{.width = 8_deg, .body = ephemeris::Body::Sun});
    ASSERT_TRUE(started) << textOf(started.error());
}

// REQ-NORTH-38d
TEST(StationCalibration, ACrossScanHearsTheReceiverAndFindsTheSun)
{
    const std::uint16_t port = fakes::unusedUdpPort();
    CalibratedStation rig(withReceiver(port));
    Receiver receiver(rig, port,
                      {.azimuthOffset = 37.4_deg, .elevationOffset = 0.8_deg, .tiltNorth = 0.5_deg, .tiltEast = {}});
    scanTheSun(rig);
    for (int i = 0; i < 400 && rig.calibration()->progress.run == CalibrationRun::CrossScan; ++i) {
        rig.run(Seconds(0.4));
        receiver.tellPower(rig.calibration()->bodies.at(0).direction);
    }
    const auto done = rig.calibration();
    ASSERT_TRUE(done->scan) << done->progress.outcome.toStdString();
    ASSERT_EQ(1U, done->points.size());
    const SkyPointing found = receiver.truth().toSky(done->points.front().axes);
    const SkyPointing sun = done->points.front().truth;
    EXPECT_NEAR(0.0, (found.azimuth - sun.azimuth).wrapped180().degrees() * std::cos(sun.elevation.radians()), 0.1);
    EXPECT_NEAR(sun.elevation.degrees(), found.elevation.degrees(), 0.1);
    EXPECT_NEAR(6.0, done->scan->across.halfPowerWidth.degrees(), 0.6);
    // The status shows the state of the power line to the operator.
    EXPECT_EQ(QStringLiteral("UDP 127.0.0.1:%1").arg(port), done->powerLine.name);
    EXPECT_TRUE(done->powerLine.decibels);
    EXPECT_TRUE(done->powerLine.problem.isEmpty());
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{done->proposal->number}));
    EXPECT_NEAR(37.4, rig.saved->pointing.azimuthOffset.degrees(), 1.0);  // this includes the effect of the tilt
}

// The receiver kept reporting while the beam was on its way: none of these powers belongs to the place of the beam.
// REQ-NORTH-38d
TEST(StationCalibration, ASilentReceiverEndsTheScanWithTheReason)
{
    const std::uint16_t port = fakes::unusedUdpPort();
    CalibratedStation rig(withReceiver(port));
    Receiver receiver(rig, port, {});
    scanTheSun(rig);
    receiver.tell("-60");
    rig.run(Seconds(20.0));
    EXPECT_TRUE(rig.calibration()->wantsPower);
    EXPECT_FALSE(rig.calibration()->power);
    EXPECT_NEAR(20.0, rig.calibration()->powerLine.age.count(), 0.5);
    EXPECT_TRUE(rig.calibration()->powerLine.problem.contains(QStringLiteral("No data")));
    rig.run(Seconds(110.0));
    EXPECT_EQ(CalibrationRun::None, rig.calibration()->progress.run);
    EXPECT_EQ(QStringLiteral("No power reading received."), rig.calibration()->progress.outcome);
    int told = 0;
    ASSERT_TRUE(rig.ask(request::AcknowledgeAlarms{}));
    for (const LogEntry& entry : rig.log) {
        told += entry.source == QLatin1String("power") ? 1 : 0;
    }
    // since the receiver fell silent, and perhaps before its first report: the line is read independently of the clock
    EXPECT_GE(told, 1);
    // Another power line, or none, applies at once.
    profile::Profile without = withReceiver(port);
    without.power.source = profile::PowerSource::None;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{without}));
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.calibration()->powerLine.name.isEmpty());
    ASSERT_TRUE(rig.ask(request::ApplyProfile{withReceiver(port)}));
    receiver.tell("-61");
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.calibration()->powerLine.decibels, -61.0);
}

}  // namespace
}  // namespace boresight

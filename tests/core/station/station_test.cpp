// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station.h"

#include "core/messages/protocol_line.h"
#include "core/night/night_desk.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/core/station/linked_station.h"
#include "tests/fakes/tcp_peer.h"
#include "tests/fakes/text_of.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace boresight {
namespace {

using Rig = LinkedStation;

// A station on the simulated mount, with drives that passed the drive check and may move.
struct CheckedRig
{
    CheckedRig()
    {
        auto owned = std::make_unique<SimulatedLink>(clock);
        link = owned.get();
        station = std::make_unique<Station>(anyPort(),
                                            moteusRotator(std::move(owned), {stateDir.path(), Simulation::Reference}),
                                            stateDir.path(), clock);
        QObject::connect(station.get(), &Station::updated,
                         [this](const StationUpdate& update) { updates.push_back(update); });
    }

    void run(int ticks)
    {
        for (int i = 0; i < ticks; ++i) {
            clock.advance(Seconds(0.02));
            link->deliver();
            station->tick();
        }
    }

    QTemporaryDir stateDir;
    fakes::ManualClock clock;
    SimulatedLink* link = nullptr;
    std::unique_ptr<Station> station;
    std::vector<StationUpdate> updates;
};

constexpr int kStationDriveCheck = 200;  // ticks; it takes 2.4 s

const request::PointSky kFarAway{{.azimuth = 200_deg, .elevation = 60_deg}};

// REQ-STATION-17: A stalled screen receives the newest status and no queue. STOP does not wait for a tick. A bus or
// port that does not open raises an alarm, and everything else works.
TEST(Station, AStalledScreenGetsTheNewestStatusAndNoQueue)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    for (int i = 0; i < 100; ++i) {
        rig.tick();
        rig.station->publish();
    }
    ASSERT_EQ(rig.updates.size(), 1U);
    rig.station->updateTaken();
    rig.station->publish();
    ASSERT_EQ(rig.updates.size(), 2U);
    EXPECT_EQ(rig.updates.back().status.tick, 105U);
}

// REQ-STATION-22: Each tick gives one sample: the set-point and the reply to it. A tick without a reply gives no
// sample. A stalled screen misses samples older than 10 s.
TEST(Station, EveryTickIsSampledOnceWithTheAnswerToIt)
{
    CheckedRig rig;
    rig.station->openAll();
    rig.run(kStationDriveCheck);
    rig.station->request({.id = 1, .request = kFarAway});
    rig.run(100);
    rig.station->publish();
    rig.station->updateTaken();
    for (int update = 0; update < 20; ++update) {
        rig.run(3);
        rig.station->publish();
        rig.station->updateTaken();
        const std::vector<TickSample>& samples = rig.updates.back().samples;
        ASSERT_EQ(samples.size(), 3U);
        EXPECT_EQ(samples[2].time, rig.clock.now() - std::chrono::milliseconds(20));
        for (std::size_t i = 1; i < samples.size(); ++i) {
            EXPECT_EQ(samples[i].time - samples[i - 1].time, std::chrono::milliseconds(20));
        }
        const AxisSample& azimuth = samples[2].axes[0];
        ASSERT_TRUE(azimuth.commanded && azimuth.actual && azimuth.torque && azimuth.current && azimuth.busVoltage);
        // At 2°/s and more the position of the previous tick would be 0.04° away.
        EXPECT_NEAR(azimuth.commanded->degrees(), azimuth.actual->degrees(), 0.03);
        EXPECT_GT(*azimuth.actual, 1_deg);
    }
}

// REQ-STATION-22
TEST(Station, ALostReplyIsNotSampledAsTheOldValue)
{
    Rig rig;
    rig.station->openAll();
    rig.run(10);
    rig.station->publish();
    rig.station->updateTaken();
    rig.azimuth.silent = true;
    rig.run(2);
    rig.station->publish();
    const std::vector<TickSample>& samples = rig.updates.back().samples;
    ASSERT_EQ(samples.size(), 2U);
    EXPECT_TRUE(samples[0].axes[0].actual);
    EXPECT_FALSE(samples[1].axes[0].actual || samples[1].axes[0].busVoltage);
    EXPECT_TRUE(samples[1].axes[1].actual);
}

// REQ-STATION-22
TEST(Station, AStalledScreenMissesTheSamplesBeyondTenSeconds)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.station->publish();
    rig.run(600);
    rig.station->updateTaken();
    rig.station->publish();
    const std::vector<TickSample>& samples = rig.updates.back().samples;
    ASSERT_EQ(samples.size(), 500U);
    EXPECT_EQ(samples.back().time, rig.clock.now() - std::chrono::milliseconds(20));
}

TEST(Station, LogLinesComeOnceAndInOrder)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.station->publish();
    ASSERT_FALSE(rig.updates.back().log.empty());
    const std::uint64_t last = rig.updates.back().log.back().number;
    rig.station->request({.id = 1, .request = kFarAway});
    rig.station->updateTaken();
    rig.station->publish();
    ASSERT_FALSE(rig.updates.back().log.empty());
    EXPECT_EQ(rig.updates.back().log.front().number, last + 1);
}

// REQ-STATION-970: The screen receives each line of the protocol log once. The log is off until the operator begins it.
// The schedule stays armed when the log begins or ends.
TEST(Station, LinesOfClientsComeOnceWhileTheirLogIsOn)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    const std::string address = rig.station->status().listening.toStdString();
    fakes::TcpPeer peer("127.0.0.1", static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))),
                        [] { QCoreApplication::processEvents(QEventLoop::AllEvents); });
    const auto publish = [&rig] {
        rig.station->updateTaken();
        rig.station->publish();
        return rig.updates.back();
    };
    ASSERT_NE(peer.ask("_\n"), "");
    EXPECT_EQ(publish().protocol, nullptr) << "it is off after a start";
    EXPECT_FALSE(publish().status.isProtocolLogged);
    rig.station->request({.id = 1, .request = request::LogProtocol{}});
    ASSERT_NE(peer.ask("_\n"), "");
    const StationUpdate update = publish();
    EXPECT_TRUE(update.status.isProtocolLogged);
    ASSERT_NE(update.protocol, nullptr);
    ASSERT_EQ(update.protocol->size(), 1U);
    EXPECT_EQ(bytesText(update.protocol->front().line).toStdString(), "_");
    EXPECT_EQ(update.protocol->front().clientId, update.status.clients.front().id);
    EXPECT_EQ(publish().protocol, nullptr);
    rig.station->request({.id = 2, .request = request::LogProtocol{.on = false}});
    ASSERT_NE(peer.ask("_\n"), "");
    EXPECT_EQ(publish().protocol, nullptr);
    EXPECT_TRUE(leavesTheMount(request::LogProtocol{}));
}

TEST(Station, AnswersFindTheControlThatAsked)
{
    CheckedRig rig;
    rig.station->openAll();
    rig.run(kStationDriveCheck);
    rig.station->request({.id = 7, .request = kFarAway});
    rig.station->request({.id = 8, .request = request::PointSky{{.azimuth = 0_deg, .elevation = -20_deg}}});
    rig.station->publish();
    const auto& answers = rig.updates.back().answers;
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_EQ(answers[0].requestId, 7U);
    EXPECT_FALSE(answers[0].error);
    EXPECT_EQ(answers[1].requestId, 8U);
    ASSERT_TRUE(answers[1].error);
    EXPECT_EQ(answers[1].error->code, ErrorCode::OutOfRange);
}

// REQ-STATION-17
TEST(Station, StopDoesNotWaitForTheNextTick)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.station->request({.id = 1, .request = kFarAway});
    rig.run(100);
    rig.link->sent.clear();
    rig.station->request({.id = 2, .request = request::Stop{}});
    EXPECT_EQ(rig.link->sent.size(), 2U);
    EXPECT_EQ(rig.station->status().state, StationState::Stopped);
}

// REQ-STATION-43c: A port that every computer can reach, without a list of permitted clients, raises an advisory.
TEST(Station, APortForEveryComputerIsAnAdvisory)
{
    profile::Profile profile = anyPort();
    profile.rotctld.listen.host = "0.0.0.0";
    Rig rig(profile);
    rig.station->openAll();
    ASSERT_EQ(rig.station->status().alarms.size(), 1U);
    const Alarm told = rig.station->status().alarms.front();
    EXPECT_EQ(told.severity, Severity::Advisory);
    EXPECT_TRUE(told.what.startsWith(QStringLiteral("Every computer that reaches 0.0.0.0:")));
    profile.rotctld.allow = {"192.168.1.0/24"};
    rig.station->request({.id = 1, .request = request::ApplyProfile{profile}});
    EXPECT_TRUE(rig.station->status().alarms.empty());

    Rig local;
    local.station->openAll();
    EXPECT_TRUE(local.station->status().alarms.empty());
}

TEST(Station, AWrongPortIsNotSaidToBeTriedAgain)
{
    Rig rig;
    rig.station->openAll();
    rig.link->report({.state = LinkState::Lost, .text = QStringLiteral("no fdcanusb answers"), .leftAlone = true});
    EXPECT_EQ(rig.station->status().alarms.front().action,
              QStringLiteral("Boresight can command nothing. It sends nothing more to this port."));
}

// REQ-STATION-17
TEST(Station, AnOccupiedPortIsSaidAndTheRestWorks)
{
    QTcpServer other;
    ASSERT_TRUE(other.listen(QHostAddress::LocalHost));
    profile::Profile profile;
    profile.rotctld.listen.port = other.serverPort();
    Rig rig(profile);
    QSignalSpy started(rig.station.get(), &Station::started);
    rig.station->openAll();
    ASSERT_EQ(started.size(), 1);
    EXPECT_TRUE(started[0][0].toString().isEmpty());
    EXPECT_FALSE(started[0][1].toString().isEmpty());
    rig.run(5);
    EXPECT_EQ(rig.station->status().state, StationState::Standby);
    EXPECT_EQ(rig.station->status().alarms.size(), 1U);
}

TEST(Station, SaysThatItHasStartedWhenThereIsAPositionOrNoneToExpect)
{
    CheckedRig checked;
    QSignalSpy ready(checked.station.get(), &Station::started);
    checked.station->openAll();
    checked.run(kStationDriveCheck);
    ASSERT_EQ(ready.size(), 1);
    EXPECT_EQ(ready[0][0].toString(), checked.station->status().listening);

    Rig silent;
    silent.azimuth.silent = silent.elevation.silent = true;
    QSignalSpy started(silent.station.get(), &Station::started);
    silent.station->openAll();
    silent.run(20);
    EXPECT_TRUE(started.isEmpty());
    silent.run(10);
    EXPECT_EQ(started.size(), 1);
}

// Story: an axis that the mount does not have counted as a drive that replies, so the start waited for the drive check.
TEST(Station, SaysThatItHasStartedWhereTheOnlyDriveIsSilent)
{
    fakes::ManualClock clock;
    const QTemporaryDir stateDir;
    const MountMaker mount =
        moteusRotator(std::make_unique<fakes::FakeCanLink>(),
                      {.stateDir = stateDir.path(), .simulation = Simulation::Reference, .axes = axesIf(true, false)});
    Station station(anyPort(), mount, stateDir.path(), clock);
    QSignalSpy started(&station, &Station::started);
    station.openAll();
    for (int i = 0; i < 30; ++i) {
        clock.advance(Seconds(0.02));
        station.tick();
    }
    EXPECT_EQ(started.size(), 1);
}

TEST(Station, FinishesAfterTheMountStandsStill)
{
    CheckedRig rig;
    rig.station->openAll();
    rig.run(kStationDriveCheck);
    rig.station->request({.id = 1, .request = kFarAway});
    rig.run(100);
    QSignalSpy finished(rig.station.get(), &Station::finished);
    rig.station->shutDown();
    rig.run(10);
    EXPECT_TRUE(finished.isEmpty()) << "it is still decelerating";
    rig.run(200);
    EXPECT_EQ(finished.size(), 1);
    EXPECT_EQ(rig.link->status().state, LinkState::Closed);
}

TEST(Station, AppliedSettingsAreInForceAndShownAsTheObjectThatIsObeyed)
{
    CheckedRig rig;
    rig.station->openAll();
    rig.run(kStationDriveCheck);
    QSignalSpy applied(rig.station.get(), &Station::profileApplied);
    profile::Profile wanted = anyPort();
    wanted.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 190_deg, .azimuthTo = 210_deg, .elevationMin = 0_deg, .elevationMax = 80_deg}};
    wanted.control.tickHz = 100;
    rig.station->request({.id = 1, .request = request::ApplyProfile{wanted}});
    rig.run(2);
    const StationStatus status = rig.station->status();
    EXPECT_EQ(status.profile->limits, wanted.limits);
    EXPECT_EQ(status.profile->control.tickHz, 50) << "waits for the new connection";
    EXPECT_EQ(status.waitingKeys, std::vector<std::string>{"control.tick_hz"});
    EXPECT_EQ(applied.size(), 1);
    rig.station->request({.id = 2, .request = kFarAway});
    rig.run(1);
    rig.station->updateTaken();
    rig.station->publish();
    ASSERT_FALSE(rig.updates.empty());
    const Answer& answer = rig.updates.back().answers.back();
    ASSERT_TRUE(answer.error);
    EXPECT_NE(textOf(*answer.error).find("mast"), std::string::npos) << textOf(*answer.error);
}

TEST(Station, ReconnectEndsInTheOrderlyWayAndAsksForTheNextStation)
{
    CheckedRig rig;
    rig.station->openAll();
    rig.run(kStationDriveCheck);
    QSignalSpy finished(rig.station.get(), &Station::finished);
    QSignalSpy wanted(rig.station.get(), &Station::reconnectWanted);
    rig.station->request({.id = 1, .request = kFarAway});
    rig.run(50);
    profile::Profile next = anyPort();
    next.mount.name = "the other mount";
    rig.station->request({.id = 2, .request = request::Reconnect{next}});
    rig.run(300);
    EXPECT_TRUE(wanted.isEmpty()) << "not while the mount moves";
    rig.station->request({.id = 3, .request = request::Hold{}});
    rig.run(200);
    rig.station->request({.id = 4, .request = request::Reconnect{next}});
    rig.run(50);
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_EQ(wanted.front().front().value<profile::Profile>().mount.name, "the other mount");
    EXPECT_TRUE(finished.isEmpty());
    EXPECT_EQ(rig.link->status().state, LinkState::Closed);
}

// REQ-STATION-49
TEST(Station, ReconnectToARealMountRefusesAProfileForASimulation)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    QSignalSpy wanted(rig.station.get(), &Station::reconnectWanted);
    profile::Profile next = anyPort();
    next.bus = "socketcan:can0";
    next.azimuth.driver = next.elevation.driver = profile::AxisDriver::Simple;
    rig.station->request({.id = 1, .request = request::Reconnect{next}});
    rig.run(5);
    rig.station->publish();
    ASSERT_EQ(rig.updates.back().answers.size(), 1U);
    const auto& error = rig.updates.back().answers.front().error;
    ASSERT_TRUE(error);
    EXPECT_NE(textOf(*error).find("only simulated"), std::string::npos) << textOf(*error);
    EXPECT_TRUE(wanted.isEmpty());
    EXPECT_EQ(rig.station->status().state, StationState::Standby) << "the mount of before stays connected";
}

// The disk has its own speed, independent of the test clock.
bool ticksUntil(Rig& rig, const std::function<bool()>& condition)
{
    const QDeadlineTimer limit(std::chrono::seconds(10));
    while (!condition() && !limit.hasExpired()) {
        rig.tick();
    }
    return condition();
}

// REQ-ALARMS-47
TEST(Station, TheLogIsOnDisk)
{
    Rig rig;
    rig.station->openAll();
    EXPECT_TRUE(ticksUntil(rig, [&rig] {
        QFile file(rig.stateDir.filePath(QStringLiteral("events.log")));
        return file.open(QIODevice::ReadOnly) &&
               file.readAll().contains("Z station: every drive answers, and nothing moves\n");
    }));
}

// REQ-ALARMS-47
TEST(Station, TheLastLinesAreOnDisk)
{
    Rig rig;
    rig.station->openAll();
    rig.run(5);
    rig.station->shutDown();
    rig.run(5);
    rig.station.reset();
    QFile file(rig.stateDir.filePath(QStringLiteral("events.log")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("Boresight is closing"));
}

// REQ-ALARMS-47
TEST(Station, ALogThatCannotBeWrittenIsAnAlarmUntilItCan)
{
    Rig rig;
    const QString log = rig.stateDir.filePath(QStringLiteral("events.log"));
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/full"), log));
    rig.station->openAll();
    const auto isTold = [&rig] {
        const auto alarms = rig.station->status().alarms;
        return std::ranges::any_of(alarms, [](const Alarm& alarm) {
            return alarm.active && alarm.what.contains(QStringLiteral("events.log"));
        });
    };
    EXPECT_TRUE(ticksUntil(rig, isTold));
    ASSERT_TRUE(QFile::remove(log));
    rig.clock.advance(EventFile::kRetry);
    EXPECT_TRUE(ticksUntil(rig, [&] { return !isTold(); }));
}

}  // namespace
}  // namespace boresight

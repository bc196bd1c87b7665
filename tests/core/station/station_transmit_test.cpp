// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_transmit.h"

#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/played_output.h"
#include "tests/fakes/wait_until.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace boresight {
namespace {

using fakes::PlayedOutput;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

profile::Profile held(const std::string& output)
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.mount.beamWidth = 10_deg;
    profile.transmit.output = output;
    profile.transmit.inSimulation = profile::InSimulation::On;
    return profile;
}

// A control that the test plays: the mount is on its target, at 40° elevation.
class StationTransmitTest : public testing::Test
{
protected:
    StationTransmitTest()
    {
        status.state = StationState::Track;
        status.aimed = true;
        status.target = SkyPointing{.azimuth = 120_deg, .elevation = 40_deg};
        status.actual = status.target;
        status.azimuth.age = status.elevation.age = std::chrono::milliseconds(20);
        transmit.setMaker([this](const contacts::OutputName& name) {
            auto made = name.kind == contacts::OutputKind::None ? nullptr : std::make_unique<PlayedOutput>(calls);
            output = made.get();
            return made;
        });
    }
    void tick(int count = 1)
    {
        for (int i = 0; i < count; ++i) {
            clock.advance(Seconds(0.02));
            transmit.tick(status);
            alarms.tick();
        }
    }
    void begin()
    {
        transmit.open();
        tick(30);
        ASSERT_TRUE(transmit.status().on);
        calls.clear();
    }
    [[nodiscard]] std::vector<std::string> take() { return std::exchange(calls, {}); }
    [[nodiscard]] std::vector<std::string> alarmTexts() const
    {
        std::vector<std::string> texts;
        for (const Alarm& alarm : alarms.list()) {
            if (alarm.active) {
                texts.push_back(alarm.what.toStdString());
            }
        }
        return texts;
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::InForce inForce{held("dtr:/dev/ttyUSB0")};
    std::vector<std::string> calls;
    PlayedOutput* output = nullptr;
    StationTransmit transmit{inForce, false, clock, log, alarms, nullptr};
    StationStatus status;
};

// REQ-TRANSMIT-20: The output is off from the start. It is on only while the mount is aimed at a target and the beam is
// near the target. It is set again each second.
TEST_F(StationTransmitTest, IsOffFromTheStart)
{
    status.aimed = false;
    transmit.open();
    EXPECT_THAT(take(), ElementsAre("off"));
    tick(120);
    EXPECT_THAT(take(), ElementsAre("off", "off"));
    EXPECT_FALSE(transmit.status().on);
    EXPECT_EQ(transmit.status().whyOff, QStringLiteral("The mount has no target."));
    status.aimed = true;
    tick(26);
    EXPECT_THAT(take(), ElementsAre("on"));
    tick(100);
    EXPECT_THAT(take(), ElementsAre("on", "on"));
    EXPECT_TRUE(transmit.status().on);
    EXPECT_EQ(transmit.status().whyOff, QString());
}

// REQ-TRANSMIT-21: The output goes off in the same tick when the beam leaves the target, STOP is latched, a fault
// occurs, the target sets or leaves the limits, its file becomes stale, or the position is older than 0.5 s.
TEST_F(StationTransmitTest, IsOffInTheTickInWhichSomethingIsInTheWay)
{
    const auto whyOffWith = [this](const auto& change) {
        const StationStatus before = status;
        begin();
        clock.advance(Seconds(20.0));  // the log drops lines that come too fast
        tick();
        calls.clear();
        change();
        tick();
        EXPECT_THAT(take(), ElementsAre("off"));
        EXPECT_FALSE(transmit.status().on);
        status = before;
        return log.since(0, 1000).back().text.toStdString();
    };
    EXPECT_EQ(whyOffWith([this] { status.actual->elevation = 42.6_deg; }),
              "off: The beam is 2.60° from the target. The limit is 2.50°.");
    EXPECT_EQ(whyOffWith([this] { status.stopLatched = true; }), "off: STOP is latched.");
    EXPECT_EQ(whyOffWith([this] { status.state = StationState::Fault; }),
              "off: The mount has a fault or does not reply.");
    EXPECT_EQ(whyOffWith([this] { status.state = StationState::Disconnected; }),
              "off: The mount has a fault or does not reply.");
    EXPECT_EQ(whyOffWith([this] { status.tracked = TrackedTarget{.name = QStringLiteral("ISS"), .isUp = false}; }),
              "off: The target is below the horizon.");
    EXPECT_EQ(whyOffWith([this] {
                  status.limited = true;
                  status.actual = status.target;  // of the nearest permitted place
              }),
              "off: The target is outside the limits of the mount.");
    EXPECT_EQ(whyOffWith([this] { status.azel.phase = AzelPhase::Stale; }), "off: The mount has no target.");
    EXPECT_EQ(whyOffWith([this] { status.elevation.age = std::chrono::milliseconds(500); }),
              "off: The mount reports no position.");
    EXPECT_EQ(whyOffWith([this] { status.azimuth.age.reset(); }), "off: The mount reports no position.");
    EXPECT_EQ(whyOffWith([this] { status.actual.reset(); }), "off: The mount reports no position.");
}

// REQ-TRANSMIT-22: An output that fails raises an alarm and counts as off. It is left off for 10 s, then it is tried
// again. The alarm ends when the output has the wanted state.
TEST_F(StationTransmitTest, AnOutputThatFailsCountsAsOff)
{
    begin();
    output->trouble = QStringLiteral("/dev/ttyUSB0: Input/output error");
    tick(50);
    EXPECT_THAT(take(), ElementsAre("on", "off"));
    EXPECT_FALSE(transmit.status().on);
    EXPECT_EQ(transmit.status().problem, output->trouble);
    EXPECT_THAT(alarmTexts(), ElementsAre("The transmit output dtr:/dev/ttyUSB0 does not work: "
                                          "/dev/ttyUSB0: Input/output error."));
    output->trouble.clear();
    tick(400);
    EXPECT_THAT(take(), testing::Each("off"));
    EXPECT_THAT(alarmTexts(), testing::SizeIs(1)) << "it should be on";
    tick(200);
    EXPECT_EQ(take().back(), "on");
    EXPECT_TRUE(transmit.status().on);
    EXPECT_EQ(transmit.status().problem, QString());
    EXPECT_THAT(alarmTexts(), IsEmpty());
}

// REQ-TRANSMIT-22
TEST_F(StationTransmitTest, AnOutputThatCannotBeOffIsTriedEachSecond)
{
    begin();
    output->trouble = QStringLiteral("no");
    status.aimed = false;
    tick(1);
    EXPECT_THAT(take(), ElementsAre("off"));
    EXPECT_THAT(alarmTexts(), testing::SizeIs(1));
    tick(100);
    EXPECT_THAT(take(), ElementsAre("off", "off"));
    output->trouble.clear();
    tick(50);
    EXPECT_THAT(alarmTexts(), IsEmpty());
}

// REQ-TRANSMIT-23: An output that does not answer for 5 s has failed.
TEST_F(StationTransmitTest, AnOutputThatDoesNotAnswerHasFailed)
{
    begin();
    output->answers = false;
    tick(250);
    EXPECT_THAT(alarmTexts(), IsEmpty());
    tick(60);
    EXPECT_THAT(alarmTexts(), ElementsAre(HasSubstr("no answer for 5 s")));
    EXPECT_EQ(take().back(), "off");
    EXPECT_FALSE(transmit.status().on);
}

// REQ-TRANSMIT-24: A change of the profile switches the output off, and its settling time starts again. Another output
// starts when the old one is off. At the end of the program it is off.
TEST_F(StationTransmitTest, AChangeOfTheProfileSwitchesItOff)
{
    const auto apply = [this](const profile::Profile& next) {
        const profile::Profile before = *inForce;
        inForce.apply(next);
        status.profile = std::make_shared<const profile::Profile>(next);
        transmit.profileChanged(before, next);
    };
    begin();
    profile::Profile next = *inForce;
    next.mount.beamWidth = 8_deg;
    apply(next);
    EXPECT_THAT(take(), ElementsAre("off"));
    tick(25);
    EXPECT_THAT(take(), IsEmpty());
    tick(2);
    EXPECT_THAT(take(), ElementsAre("on"));
    EXPECT_EQ(transmit.status().within, 2_deg);
    next.mqtt.host = "elsewhere";  // a serial port does not use this setting
    apply(next);
    EXPECT_THAT(take(), ElementsAre("off"));

    output->answers = false;
    next.transmit.output = "rts:/dev/ttyUSB0";
    apply(next);
    tick(30);
    EXPECT_EQ(calls.front(), "off");
    EXPECT_EQ(std::ranges::count(take(), "gone"), 0);
    EXPECT_EQ(transmit.status().whyOff, QStringLiteral("The previous output has not answered yet."));
    Q_EMIT output->failed(QStringLiteral("unplugged"));
    ASSERT_TRUE(fakes::waitUntil([this] { return calls.size() >= 2; }));
    EXPECT_THAT(take(), ElementsAre("gone", "off"));
    next.transmit.output.clear();
    apply(next);
    ASSERT_TRUE(fakes::waitUntil([this] { return !calls.empty() && calls.back() == "gone"; }));
    EXPECT_EQ(calls.front(), "off");
}

// REQ-TRANSMIT-28: An output with a running program or call is deleted only after that has ended, so that nobody waits
// for it.
TEST_F(StationTransmitTest, AnOutputIsNotEndedWhileSomethingRuns)
{
    begin();
    output->idle = false;
    const profile::Profile before = *inForce;
    profile::Profile next = before;
    next.transmit.output = "rts:/dev/ttyUSB0";
    inForce.apply(next);
    transmit.profileChanged(before, next);
    EXPECT_THAT(take(), ElementsAre("off"));
    QCoreApplication::processEvents();
    EXPECT_THAT(take(), IsEmpty()) << "it is off, and something of it still runs";
    Q_EMIT output->failed(QStringLiteral("ended after 2 s"));
    QCoreApplication::processEvents();
    EXPECT_THAT(take(), IsEmpty());
    output->idle = true;
    Q_EMIT output->reached(false);
    QCoreApplication::processEvents();
    EXPECT_THAT(take(), ElementsAre("gone", "off"));
}

// REQ-TRANSMIT-24
TEST_F(StationTransmitTest, TheEndSwitchesItOff)
{
    begin();
    transmit.close();
    EXPECT_THAT(take(), ElementsAre("off"));
    tick(100);
    EXPECT_THAT(take(), IsEmpty());
}

// REQ-TRANSMIT-25: With a simulated mount the output stays off, unless the profile permits it.
TEST_F(StationTransmitTest, ASimulatedMountSwitchesNothing)
{
    profile::Profile next = *inForce;
    next.transmit.inSimulation = profile::InSimulation::Off;
    inForce.apply(next);
    StationTransmit simulated(inForce, true, clock, log, alarms, nullptr);
    simulated.setMaker([this](const contacts::OutputName&) { return std::make_unique<PlayedOutput>(calls); });
    simulated.open();
    for (int i = 0; i < 100; ++i) {
        clock.advance(Seconds(0.02));
        simulated.tick(status);
    }
    EXPECT_THAT(calls, testing::Each("off"));
    EXPECT_THAT(simulated.status().whyOff.toStdString(), HasSubstr("simulated"));
}

// A whole station with the simulated mount, and a file as its transmit output.
class TransmitFileTest : public testing::Test
{
protected:
    void SetUp() override
    {
        auto owned = std::make_unique<SimulatedLink>(clock);
        link = owned.get();
        profile::Profile profile = held("file:" + path.toStdString());
        profile.mount.beamWidth = 4_deg;
        profile.antennas = {{.name = "wide", .beamWidth = 20_deg}};
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(owned), {stateDir.path(), Simulation::Reference}), stateDir.path(), clock);
        station->openAll();
        run(4.0);
    }
    void tick()
    {
        clock.advance(Seconds(0.02));
        link->deliver();
        station->tick();
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            tick();
        }
    }
    void ask(const Request& request) { station->request({.id = 1, .request = request}); }
    [[nodiscard]] bool fileSays(const QByteArray& line) const
    {
        return fakes::waitUntil([&] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) && file.readAll() == line;
        });
    }
    // Runs until the decision is made and the file follows it.
    [[nodiscard]] bool becomes(bool on, double seconds = 60.0)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            tick();
            if (station->status().transmit.whyOff.isEmpty() == on) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] Angle error() const { return station->status().transmit.error.value_or(180_deg); }

    fakes::ManualClock clock;
    QTemporaryDir stateDir;
    QString path = stateDir.filePath(QStringLiteral("transmit"));
    SimulatedLink* link = nullptr;
    std::unique_ptr<Station> station;
};

// REQ-TRANSMIT-26: With the mount: the output is on when a go-to arrives, and off as soon as the mount leaves. Parking,
// a jog, home, an unwrapped cable and a held mount are no target.
TEST_F(TransmitFileTest, FollowsTheMount)
{
    EXPECT_TRUE(fileSays("off\n"));
    ask(request::PointSky{{.azimuth = 60_deg, .elevation = 30_deg}});
    ASSERT_TRUE(becomes(true));
    EXPECT_LT(error(), 0.9_deg);
    EXPECT_TRUE(fileSays("on\n"));
    run(20.0);
    EXPECT_LT(error(), 0.1_deg);
    ask(request::PointSky{{.azimuth = 90_deg, .elevation = 30_deg}});
    ASSERT_TRUE(becomes(false, 0.1));
    EXPECT_TRUE(fileSays("off\n"));
    ASSERT_TRUE(becomes(true));
    ask(request::Hold{});
    ASSERT_TRUE(becomes(false, 0.04));
    for (const Request& place : {Request(request::Park{}), Request(request::Home{}), Request(request::Unwind{})}) {
        ask(place);
        EXPECT_FALSE(becomes(true, 40.0));
    }
    EXPECT_TRUE(fileSays("off\n"));
}

// Story: the limit was that of a 10° beam, whatever the profile said. With a 2° beam a transmitter was permitted 2.5°
// beside the target.
// REQ-TRANSMIT-29: The limit is a part of the beam width of the antenna in use.
TEST_F(TransmitFileTest, GoesByTheBeamInUse)
{
    EXPECT_EQ(station->status().transmit.within, 1_deg);
    ask(request::UseAntenna{"wide"});
    tick();
    EXPECT_EQ(station->status().transmit.within, 5_deg);
}

// REQ-TRANSMIT-27: STOP, a silent drive and the end of the program switch the output off.
TEST_F(TransmitFileTest, StopSwitchesItOff)
{
    ask(request::PointSky{{.azimuth = 60_deg, .elevation = 30_deg}});
    ASSERT_TRUE(becomes(true));
    ask(request::Stop{});
    EXPECT_FALSE(station->status().transmit.whyOff.isEmpty()) << "without another tick";
    EXPECT_TRUE(fileSays("off\n"));
    run(20.0);
    ask(request::ResetStop{});
    EXPECT_FALSE(becomes(true, 5.0)) << "nothing begins by itself";
}

// REQ-TRANSMIT-27
TEST_F(TransmitFileTest, ASilentDriveSwitchesItOff)
{
    ask(request::PointSky{{.azimuth = 60_deg, .elevation = 30_deg}});
    ASSERT_TRUE(becomes(true));
    link->inject({.kind = sim::FaultKind::Silence, .axis = Axis::Elevation});
    ASSERT_TRUE(becomes(false, 0.6));
    EXPECT_TRUE(fileSays("off\n"));
}

// REQ-TRANSMIT-27
TEST_F(TransmitFileTest, TheEndOfTheProgramSwitchesItOff)
{
    ask(request::PointSky{{.azimuth = 60_deg, .elevation = 30_deg}});
    ASSERT_TRUE(becomes(true));
    ASSERT_TRUE(fileSays("on\n"));
    station->shutDown();
    EXPECT_TRUE(fileSays("off\n")) << "while the mount still slows down";
    run(5.0);
    station.reset();
    EXPECT_TRUE(fileSays("off\n"));
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/played_output.h"

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

using testing::Contains;
using testing::Each;

// A whole station with the simulated mount and a brake.
class BrakeSwitchingTest : public testing::Test
{
protected:
    BrakeSwitchingTest()
    {
        auto owned = std::make_unique<SimulatedLink>(clock);
        link = owned.get();
        profile::Profile profile;
        profile.rotctld.listen.port = 0;
        profile.brake = {.output = "file:" + path.toStdString(), .switching = Seconds(0.4), .setAfter = Seconds(3.0)};
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(owned), {stateDir.path(), Simulation::Reference}), stateDir.path(), clock);
    }
    void play()
    {
        station->setBrakeMaker([this](const contacts::OutputName& name) {
            auto made =
                name.kind == contacts::OutputKind::None ? nullptr : std::make_unique<fakes::PlayedOutput>(calls);
            output = made.get();
            return made;
        });
    }
    void open()
    {
        station->openAll();
        run(4.0);
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            clock.advance(Seconds(0.02));
            link->deliver();
            station->tick();
        }
    }
    void ask(const Request& request) { station->request({.id = 1, .request = request}); }
    void goTo(Angle azimuth) { ask(request::PointSky{{.azimuth = azimuth, .elevation = 30_deg}}); }
    [[nodiscard]] AngularRate rate() const { return station->status().azimuth.commandedRate.value_or(AngularRate{}); }

    fakes::ManualClock clock;
    QTemporaryDir stateDir;
    QString path = stateDir.filePath(QStringLiteral("brake"));
    SimulatedLink* link = nullptr;
    std::vector<std::string> calls;
    fakes::PlayedOutput* output = nullptr;
    std::unique_ptr<Station> station;
};

// REQ-BRAKE-22: The output is off from the start and at the end of the program, also at an end in the middle of a
// motion. It is set again each second. A motion switches it on. After the motion it is off.
TEST_F(BrakeSwitchingTest, TheOutputFollowsTheMotion)
{
    play();
    open();
    EXPECT_GE(calls.size(), 3U);
    EXPECT_THAT(calls, Each("off"));
    goTo(20_deg);
    run(0.1);
    EXPECT_EQ(calls.back(), "on");
    EXPECT_EQ(rate(), AngularRate{});
    run(1.0);
    EXPECT_NE(rate(), AngularRate{});
    run(30.0);
    EXPECT_EQ(calls.back(), "off");
    EXPECT_EQ(station->status().brake.state, brake::BrakeState::Set);
    goTo(120_deg);
    run(2.0);
    EXPECT_EQ(calls.back(), "on");
    station->shutDown();
    run(0.1);
    EXPECT_EQ(calls.back(), "on") << "the antenna still moves";
    run(6.0);
    EXPECT_EQ(calls.back(), "off");
    station.reset();
    ASSERT_GE(calls.size(), 2U);
    EXPECT_EQ(calls.back(), "gone");
    EXPECT_EQ(calls[calls.size() - 2], "off");
}

// REQ-BRAKE-22
TEST_F(BrakeSwitchingTest, AnEndInTheMiddleLeavesItOff)
{
    play();
    open();
    goTo(120_deg);
    run(2.0);
    ASSERT_EQ(calls.back(), "on");
    station.reset();
    EXPECT_EQ(calls.back(), "gone");
    EXPECT_EQ(calls[calls.size() - 2], "off");
}

// REQ-BRAKE-23: An output that fails, or does not answer for 5 s, raises an alarm and stops the mount.
TEST_F(BrakeSwitchingTest, AFailureIsAnAlarm)
{
    play();
    open();
    goTo(170_deg);
    run(2.0);
    output->answers = false;
    run(4.0);
    EXPECT_NE(station->status().state, StationState::Fault);
    run(3.0);
    const StationStatus status = station->status();
    EXPECT_EQ(status.state, StationState::Fault);
    EXPECT_EQ(rate(), AngularRate{});
    const auto isOfTheBrake = [](const Alarm& alarm) {
        return alarm.what.contains(QStringLiteral("no answer for 5 s"));
    };
    EXPECT_TRUE(std::ranges::any_of(status.alarms, isOfTheBrake));
}

// REQ-BRAKE-33: An output that has failed is not switched on again while the antenna stops.
TEST_F(BrakeSwitchingTest, AFailureIsNotFollowedByOn)
{
    play();
    open();
    goTo(170_deg);
    run(6.0);
    output->trouble = QStringLiteral("unplugged");
    run(1.2);
    ASSERT_EQ(station->status().state, StationState::Fault);
    calls.clear();
    run(10.0);
    EXPECT_FALSE(calls.empty());
    EXPECT_THAT(calls, Each("off"));
}

// REQ-BRAKE-24: Another output takes the place of the first one, which is off before.
TEST_F(BrakeSwitchingTest, AnotherOutputBeginsOff)
{
    play();
    open();
    profile::Profile next = *station->status().profile;
    next.brake.output.clear();
    ask(request::ApplyProfile{next});
    EXPECT_EQ(calls.back(), "off");
    EXPECT_TRUE(station->status().brake.output.isEmpty());
    goTo(20_deg);
    run(0.5);
    EXPECT_NE(rate(), AngularRate{}) << "there is no brake to wait for";
}

// REQ-BRAKE-24
TEST_F(BrakeSwitchingTest, AnotherOutputWaitsForTheOneBefore)
{
    play();
    open();
    fakes::PlayedOutput* const before = output;
    before->answers = false;
    before->idle = false;
    profile::Profile next = *station->status().profile;
    next.brake.output += "2";
    ask(request::ApplyProfile{next});
    run(1.0);
    EXPECT_EQ(output, before);
    run(5.0);
    EXPECT_EQ(station->status().brake.problem, QStringLiteral("the output before it has not answered for 5 s"));
    goTo(20_deg);
    run(1.0);
    EXPECT_EQ(rate(), AngularRate{});
    before->idle = true;
    Q_EMIT before->reached(false);
    QCoreApplication::processEvents();
    run(1.0);
    EXPECT_THAT(calls, Contains("gone")) << "the one before";
    EXPECT_TRUE(station->status().brake.problem.isEmpty());
    goTo(20_deg);
    run(2.0);
    EXPECT_NE(rate(), AngularRate{});
}

// REQ-BRAKE-25: With a simulated mount the real brake is never released.
TEST_F(BrakeSwitchingTest, ASimulatedMountReleasesNoRealBrake)
{
    open();
    goTo(20_deg);
    run(1.0);
    EXPECT_NE(rate(), AngularRate{});
    EXPECT_EQ(station->status().brake.state, brake::BrakeState::Released);
    station.reset();
    EXPECT_FALSE(QFile::exists(path));
}

}  // namespace
}  // namespace boresight

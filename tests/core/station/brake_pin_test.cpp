// SPDX-License-Identifier: GPL-3.0-or-later
// The brakes at a pin of a board of the simulated mount: the whole station and its bus.
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"

#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

namespace boresight {
namespace {

using brake::BrakeState;

class BrakePinTest : public testing::Test
{
protected:
    explicit BrakePinTest(bool isOutput = true)
    {
        auto owned = std::make_unique<SimulatedLink>(clock, mount);
        link = owned.get();
        if (isOutput) {
            azimuth().makeOutput(1, 2);
        }
        profile::Profile profile;
        profile.rotctld.listen.port = 0;
        profile.brake = {.output = "moteus:1:aux1.2", .switching = Seconds(0.4), .setAfter = Seconds(3.0)};
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(owned), {stateDir.path(), Simulation::Reference}), stateDir.path(), clock);
        station->openAll();
        run(4.0);
    }
    sim::SimulatedMoteus& azimuth() { return mount->pair.drive(Axis::Azimuth); }
    [[nodiscard]] bool isReleased() { return azimuth().isDrivenHigh(1, 2); }
    void tick()
    {
        clock.advance(Seconds(0.02));
        link->deliver();
        station->tick();
        const bool moves = std::abs(azimuth().plant().velocity()) > 1e-4;
        movedWithBrake = movedWithBrake || (moves && !isReleased());
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            tick();
        }
    }
    void ask(const Request& request) { station->request({.id = 1, .request = request}); }
    void goTo(Angle azimuth) { ask(request::PointSky{{.azimuth = azimuth, .elevation = 30_deg}}); }
    [[nodiscard]] AngularRate rate() const { return station->status().azimuth.commandedRate.value_or(AngularRate{}); }
    [[nodiscard]] BrakeState state() const { return station->status().brake.state; }

    fakes::ManualClock clock;
    QTemporaryDir stateDir;
    std::shared_ptr<SimulatedMount> mount = std::make_shared<SimulatedMount>(clock, sim::commissionedPair());
    SimulatedLink* link = nullptr;
    std::unique_ptr<Station> station;
    bool movedWithBrake = false;
};

// REQ-BRAKE-44: With the brakes at a pin of a moteus, a motion first switches the pin on, waits for its reply and for
// the brakes, and then moves. After the motion the mount stands, waits, and switches the pin off. The end of the
// program does the same.
TEST_F(BrakePinTest, ReleasesWaitsMovesStopsWaitsSets)
{
    EXPECT_EQ(state(), BrakeState::Set);
    EXPECT_FALSE(isReleased());
    goTo(20_deg);
    run(0.3);
    EXPECT_TRUE(isReleased());
    EXPECT_EQ(rate(), AngularRate{}) << "the brakes open";
    run(1.0);
    EXPECT_NE(rate(), AngularRate{});
    while (rate() != AngularRate{}) {
        tick();
    }
    run(2.0);
    EXPECT_TRUE(isReleased()) << "it waits for another motion";
    run(5.0);
    EXPECT_FALSE(isReleased());
    EXPECT_EQ(state(), BrakeState::Set);
    EXPECT_FALSE(movedWithBrake);

    goTo(120_deg);
    run(2.0);
    ASSERT_TRUE(isReleased());
    station->shutDown();
    run(8.0);
    EXPECT_FALSE(isReleased());
    EXPECT_FALSE(movedWithBrake);
}

// REQ-BRAKE-44
TEST_F(BrakePinTest, AnEndInTheMiddleLeavesItOff)
{
    goTo(120_deg);
    run(2.0);
    ASSERT_TRUE(isReleased());
    station.reset();
    EXPECT_FALSE(isReleased());
}

class WrongPinTest : public BrakePinTest
{
protected:
    WrongPinTest() : BrakePinTest(false) {}
};

// REQ-BRAKE-45: A pin for the brakes whose mode is not digital_out is a dangerous setting of the drive: nothing moves,
// and the finding names the key, the value and the command that sets it.
TEST_F(WrongPinTest, MovesNothing)
{
    goTo(20_deg);
    run(3.0);
    EXPECT_EQ(rate(), AngularRate{});
    const StationStatus status = station->status();
    const auto isOfThePin = [](const Alarm& alarm) { return alarm.what.contains(QStringLiteral("aux1.pins.2.mode")); };
    EXPECT_TRUE(std::ranges::any_of(status.alarms, isOfThePin));
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/link_factory.h"

#include "core/drive_check/protections.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace boresight {
namespace {

SimulatedLink& simulated(const std::unique_ptr<CanLink>& link)
{
    return dynamic_cast<SimulatedLink&>(*link);
}

TEST(LinkMaker, TheSimulatedMountIsTheSameOneAfterAReconnect)
{
    fakes::ManualClock clock;
    const LinkMaker maker(profile::Profile{}, clock);
    auto first = maker.make("simulated");
    const sim::SimulatedPair* const mount = &simulated(first).pair();
    first.reset();
    clock.advance(Seconds(3.0));
    const auto second = maker.make("simulated");
    EXPECT_EQ(&simulated(second).pair(), mount);
    EXPECT_NEAR(simulated(second).pair().now().count(), 3.0, 1e-6) << "its time went on";
}

TEST(LinkMaker, TheSimulatedDrivesAreProtectedForTheProfile)
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = {.min = -30_deg, .max = 300_deg};
    sim::PairSettings pair = protectedPair(profile);
    EXPECT_NEAR(pair.azimuth.config.positionMin, -33.0 / 360.0, 1e-6);  // 3° beyond the travel
    EXPECT_NEAR(pair.azimuth.config.positionMax, 303.0 / 360.0, 1e-6);
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        sim::DriveConfig& config = (axis == Axis::Azimuth ? pair.azimuth : pair.elevation).config;
        for (const drive_check::Protection& protection : drive_check::protectionsOf(profile, axis)) {
            const auto found = sim::configText(config, protection.key);
            const drive_check::Reading reading{.state = drive_check::Reading::State::Read, .text = found.value_or("")};
            EXPECT_NE(drive_check::judged(protection, reading).verdict, Verdict::Dangerous) << protection.key;
        }
    }
}

// Story: a simulated mount with a cable to 460° ran against its stop at 458°, 2° before the cable end of its profile.
TEST(LinkMaker, TheStopsOfTheSimulatedMountStandBeyondTheTravelOfTheProfile)
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = {.min = -200_deg, .max = 460_deg};
    const sim::PlantSettings azimuth = protectedPair(profile).azimuth.plant;
    EXPECT_NEAR(azimuth.stopMin, -208.0 / 360.0, 1e-6);
    EXPECT_NEAR(azimuth.stopMax, 468.0 / 360.0, 1e-6);
}

TEST(LinkMaker, TheStopsOfTheSimulatedMountDoNotComeNearerWithAShorterTravel)
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = {.min = -30_deg, .max = 300_deg};
    const sim::PlantSettings azimuth = protectedPair(profile).azimuth.plant;
    EXPECT_NEAR(azimuth.stopMin, -98.0 / 360.0, 1e-6);
    EXPECT_NEAR(azimuth.stopMax, 458.0 / 360.0, 1e-6);
}

// Story: with --simulate=moteus and the profile of a simple rotator the drives started without their safety settings.
TEST(LinkMaker, TheSimulatedDrivesOfASimpleProfileAreProtectedToo)
{
    profile::Profile profile;
    profile.azimuth.driver = profile::AxisDriver::Simple;
    profile.azimuth.geometry.travel = {.min = -30_deg, .max = 300_deg};
    EXPECT_NEAR(protectedPair(profile).azimuth.config.positionMax, 303.0 / 360.0, 1e-6);
}

// Without these errors there would be nothing to calibrate with --simulate.
TEST(LinkMaker, TheSimulatedMountHidesAnotherNorthAndADeviation)
{
    fakes::ManualClock clock;
    auto link = LinkMaker(profile::Profile{}, clock).make("simulated");
    sim::SimulatedSensor& sensor = simulated(link).sensor();
    constexpr int kUntilSettled = 50;  // readings: they are late and averaged
    std::vector<Angle> errors;
    for (int heading = 0; heading < 360; heading += 30) {
        const AxisPosition axes{.azimuth = Angle::fromDegrees(heading), .elevation = 30_deg};
        std::optional<sim::SensorMessage> last;
        for (int reading = 0; reading < kUntilSettled; ++reading) {
            clock.advance(sim::SimulatedSensor::kReadingPeriod);
            if (auto message = sensor.read(clock.now(), clock.utc(), axes)) {
                last = std::move(message);
            }
        }
        ASSERT_TRUE(last);
        errors.push_back((Angle::fromDegrees(last->azimuth) - axes.azimuth).wrapped180());
    }
    const auto [least, most] = std::ranges::minmax(errors);
    EXPECT_LT(least, 32_deg);
    EXPECT_GT(least, 24_deg);
    EXPECT_GT(most, 42_deg);
    EXPECT_LT(most, 51_deg);
}

// If the motors are swapped in the profile, the simulated motors are not swapped along: the guide must be able to find
// the mistake.
TEST(LinkMaker, ASwappedProfileDoesNotSwapTheSimulatedMotors)
{
    profile::Profile profile;
    std::swap(profile.azimuth.id, profile.elevation.id);
    const sim::PairSettings pair = protectedPair(profile);
    EXPECT_EQ(pair.azimuth.config.id, 1);
    EXPECT_EQ(pair.elevation.config.id, 2);
    EXPECT_NEAR(pair.elevation.config.positionMax, 453.0 / 360.0, 1e-6) << "as the azimuth it is taken for";
}

// REQ-CAN-22: A name that means no bus still gives a link. The link reports the error when it is opened.
TEST(LinkMaker, ARealBusIsMadeByItsNameAndNonsenseSaysSoWhenItIsOpened)
{
    fakes::ManualClock clock;
    const LinkMaker maker(profile::Profile{}, clock);
    EXPECT_EQ(maker.make("socketcan:can0")->name(), QStringLiteral("socketcan:can0"));
    const auto nonsense = maker.make("rubbish");
    EXPECT_EQ(nonsense->name(), QStringLiteral("rubbish"));
    EXPECT_EQ(nonsense->status().state, LinkState::Lost);
    const Result<> opened = nonsense->open();
    ASSERT_FALSE(opened);
    EXPECT_NE(textOf(opened.error()).find("rubbish"), std::string::npos);
    EXPECT_FALSE(nonsense->send({}));
}

}  // namespace
}  // namespace boresight

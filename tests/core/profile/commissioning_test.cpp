// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/commissioning.h"

#include "core/profile/profile_diff.h"
#include "core/profile/setting.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace boresight::profile {
namespace {

constexpr Angle kTiny = Angle::fromDegrees(1e-9);

void expectMakesSense(const Profile& profile)
{
    for (const Problem& problem : problemsOf(profile)) {
        ADD_FAILURE() << problem.key << ": " << problem.text.toStdString();
    }
}

// REQ-PROFILE-17 (Commissioning.*): Each step of commissioning (another bus, motors swapped or reversed, a travel, a
// zero) changes all settings that belong together, and marks the directions as unconfirmed where necessary.
TEST(Commissioning, AnotherBusHasItsDirectionsUnconfirmedAndTakesTheIdsThatAnswer)
{
    Profile profile;
    useBus(profile, "simulated", std::array{1, 2});
    EXPECT_EQ(profile, Profile{}) << "nothing is new";
    useBus(profile, "socketcan:can0", std::array{2, 1});
    EXPECT_EQ(profile.bus, "socketcan:can0");
    EXPECT_EQ(profile.mount.directions, Directions::Unconfirmed);
    EXPECT_EQ(profile.azimuth.id, 1) << "both of the profile's ids answer: which is which is known already";
    profile.mount.directions = Directions::Confirmed;
    useBus(profile, "socketcan:can0", std::array{5, 7});
    EXPECT_EQ(profile.azimuth.id, 5);
    EXPECT_EQ(profile.elevation.id, 7);
    EXPECT_EQ(profile.mount.directions, Directions::Unconfirmed) << "other motors";
    expectMakesSense(profile);
}

// REQ-PROFILE-962: A rotator with its own control box becomes the mount in one step: driver, bus, speed of the port,
// and the travel and speed of a usual rotator. Choosing a bus of moteus controllers reverts this.
TEST(Commissioning, ARotatorIsTakenInOneAct)
{
    Profile profile;
    profile.mount.directions = Directions::Confirmed;
    profile.sensor.source = SensorSource::Simulated;
    EXPECT_FALSE(losesAMount(profile, AxisDriver::Rotctld));
    profile.elevation.geometry.offset = 12_deg;
    profile.azimuth.geometry.sign = -1;
    profile.pointing.azimuthOffset = 40_deg;
    EXPECT_TRUE(losesAMount(profile, AxisDriver::Rotctld));
    EXPECT_FALSE(losesAMount(profile, AxisDriver::Moteus));
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "rotctld:10.0.0.7:4533"});
    EXPECT_EQ(profile.bus, "rotctld:10.0.0.7:4533");
    EXPECT_EQ(profile.azimuth.driver, AxisDriver::Rotctld);
    EXPECT_EQ(profile.elevation.driver, AxisDriver::Rotctld);
    EXPECT_EQ(profile.azimuth.geometry.travel, (TravelRange{0_deg, 360_deg}));
    EXPECT_EQ(profile.elevation.geometry.travel, (TravelRange{0_deg, 90_deg}));
    EXPECT_EQ(profile.azimuth.geometry.sign, 1) << "its box counts";
    EXPECT_EQ(profile.elevation.geometry.offset, 0_deg);
    EXPECT_EQ(profile.pointing, Profile().pointing) << "its box counts true azimuths";
    EXPECT_EQ(profile.elevation.limits.speed, 2.5_deg_s);
    EXPECT_FALSE(losesAMount(profile, AxisDriver::Gs232));
    EXPECT_EQ(profile.mount.directions, Directions::Unconfirmed);
    EXPECT_EQ(profile.sensor.source, SensorSource::None);
    EXPECT_TRUE(fitsRealMount(profile));
    expectMakesSense(profile);

    useBus(profile, "socketcan:can0", std::array{5, 7});
    EXPECT_EQ(profile.azimuth.driver, AxisDriver::Moteus);
    EXPECT_EQ(profile.elevation.id, 7);
    EXPECT_EQ(profile.elevation.limits.speed, 2.5_deg_s) << "no faster for it";
    EXPECT_EQ(profile.azimuth.geometry.travel, Profile().azimuth.geometry.travel) << "that was the rotator's";
    EXPECT_TRUE(fitsRealMount(profile));
}

// REQ-PROFILE-965: Settings of Hamlib are for one model. Another model, or a rotator without Hamlib, resets them.
// Another port keeps them.
TEST(Commissioning, SettingsOfHamlibStayWithTheirModel)
{
    Profile profile;
    profile.hamlibSettings = {"min_az=-90"};
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "hamlib:901:/dev/ttyUSB0"});
    EXPECT_EQ(profile.hamlibSettings.size(), 1U) << "entered before the model was connected";
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "hamlib:901:/dev/ttyUSB1"});
    EXPECT_EQ(profile.hamlibSettings.size(), 1U);
    Profile other = profile;
    useRotator(other, {.driver = AxisDriver::Rotctld, .bus = "hamlib:902:/dev/ttyUSB1"});
    EXPECT_TRUE(other.hamlibSettings.empty());
    useRotator(profile, {.driver = AxisDriver::Gs232, .bus = "serial:/dev/ttyUSB1"});
    EXPECT_TRUE(profile.hamlibSettings.empty());
}

// REQ-PROFILE-966
TEST(Commissioning, StepsStayWithTheirRotator)
{
    Profile profile;
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "hamlib:901:/dev/ttyUSB0"});
    profile.azimuth.stepsPerTurn = 866.0;
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "hamlib:901:/dev/ttyUSB1"});
    EXPECT_EQ(profile.azimuth.stepsPerTurn, 866.0);
    useBus(profile, "socketcan:can0", {});
    EXPECT_EQ(profile.azimuth.stepsPerTurn, 0.0);
}

// REQ-PROFILE-962
TEST(Commissioning, ARotatorThatIsReachedElsewhereKeepsItsEnds)
{
    Profile profile;
    useRotator(profile, {.driver = AxisDriver::Gs232, .bus = "serial:/dev/ttyUSB0", .baud = 4800});
    setTravel(profile, Axis::Azimuth, {.min = 0_deg, .max = 450_deg});
    profile.mount.directions = Directions::Confirmed;
    Profile moved = profile;
    useRotator(moved, {.driver = AxisDriver::Gs232, .bus = "serial:/dev/ttyUSB0", .baud = 9600});
    EXPECT_EQ(moved.baud, 9600);
    EXPECT_EQ(moved.mount.directions, Directions::Confirmed) << "it is the same rotator";
    useRotator(moved, {.driver = AxisDriver::Gs232, .bus = "tcp:10.0.0.7:4001", .baud = 9600});
    EXPECT_EQ(moved.azimuth.geometry.travel, (TravelRange{0_deg, 450_deg}));
    EXPECT_EQ(moved.mount.directions, Directions::Unconfirmed);
    useRotator(moved, {.driver = AxisDriver::Rotctld, .bus = "rotctld:10.0.0.7:4533", .baud = 9600});
    EXPECT_EQ(moved.azimuth.geometry.travel, (TravelRange{0_deg, 450_deg})) << "the same rotator by Hamlib";
    EXPECT_EQ(moved.azimuth.driver, AxisDriver::Rotctld);
    profile.elevation.driver = AxisDriver::None;
    useRotator(profile, {.driver = AxisDriver::Rotctld, .bus = "rotctld:10.0.0.7:4533"});
    EXPECT_EQ(profile.elevation.driver, AxisDriver::None) << "a missing axis stays missing";
    EXPECT_TRUE(fitsRealMount(profile));
}

TEST(Commissioning, ARealMountHasNoSimulatedSensor)
{
    Profile profile;
    profile.sensor.source = SensorSource::Simulated;
    useBus(profile, "simulated", std::array{1, 2});
    EXPECT_EQ(profile.sensor.source, SensorSource::Simulated);
    useBus(profile, "socketcan:can0", std::array{1, 2});
    EXPECT_EQ(profile.sensor.source, SensorSource::None);
    expectMakesSense(profile);
    profile.sensor.source = SensorSource::Mqtt;
    useBus(profile, "socketcan:can1", std::array{1, 2});
    EXPECT_EQ(profile.sensor.source, SensorSource::Mqtt);
}

// Another adapter for a real mount is usually only a change of cables.
TEST(Commissioning, AnotherBusKeepsWhatWasFound)
{
    Profile real;
    real.bus = "socketcan:can0";
    real.pointing.azimuthOffset = 37.4_deg;
    real.azimuth.geometry.offset = 5_deg;
    real.sensor.source = SensorSource::Mqtt;
    Profile wanted = real;
    useBus(real, "socketcan:can1", std::array{1, 2});
    wanted.bus = "socketcan:can1";
    wanted.mount.directions = Directions::Unconfirmed;
    EXPECT_EQ(real, wanted);
}

// Story: north was applied on the simulated mount with an older version. The real mount then pointed 37.4° wrong. Zeros
// set at the position of the simulated mount would also apply to the real one, and shift the ends that are counted from
// them.
// REQ-PROFILE-17a: Settings and calibrations of a simulated mount are kept in files of the simulation. None of them
// reaches the profile of a real mount, or the other way round: in the guide, in the table, by `--bus` or by a file.
// Ends of the travel that were typed stay.
TEST(Commissioning, NothingFoundOfTheSimulatedMountHoldsOnARealOne)
{
    Profile profile;
    profile.pointing = {.azimuthOffset = 37.4_deg, .elevationOffset = 1_deg, .tiltNorth = 2_deg, .elevationSag = 1_deg};
    profile.sensor.source = SensorSource::Simulated;
    profile.sensor.mounting = {
        .sense = orientation::Sense::CounterClockwise, .azimuthOffset = 5_deg, .elevationOffset = 3_deg};
    profile.sensor.deviation = {.a1 = 3_deg, .b2 = 1_deg, .sigma = 1_deg, .elevation = 30_deg};
    profile.sensor.deviation.unreliable = {{.from = 10_deg, .to = 20_deg}};
    setReading(profile, Axis::Elevation, 3_deg, 0_deg, Ends::KeepTheirNumbers);
    setReading(profile, Axis::Azimuth, 10_deg, 47_deg, Ends::KeepTheirNumbers);
    setTravel(profile, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    profile.jog.slow = 0.7_deg_s;
    profile.bus = "socketcan:can0";
    Profile wanted;
    wanted.bus = "socketcan:can0";
    wanted.mount.directions = Directions::Unconfirmed;
    setTravel(wanted, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(forRealMount(profile), wanted);
    expectMakesSense(forRealMount(profile));
    profile.sensor.source = SensorSource::Mqtt;
    EXPECT_EQ(forRealMount(profile).sensor.source, SensorSource::Mqtt);
}

TEST(Commissioning, OneIdOrThreeTellNothing)
{
    Profile profile;
    useBus(profile, "socketcan:can0", std::array{5});
    useBus(profile, "socketcan:can0", std::array{5, 6, 7});
    useBus(profile, "socketcan:can0", std::array{5, 5});
    EXPECT_EQ(profile.azimuth.id, 1);
    EXPECT_EQ(profile.elevation.id, 2);
}

// The id of an axis without a controller has no meaning.
TEST(Commissioning, AMountWithOneControllerTakesTheOneIdThatAnswers)
{
    Profile profile;
    profile.elevation.driver = AxisDriver::None;
    useBus(profile, "socketcan:can0", std::array{3, 5});
    EXPECT_EQ(profile.azimuth.id, 1) << "nobody knows which one it is";
    useBus(profile, "socketcan:can0", std::array{5});
    EXPECT_EQ(profile.azimuth.id, 5);
    EXPECT_EQ(profile.elevation.id, 2);
    profile.mount.directions = Directions::Confirmed;
    useBus(profile, "socketcan:can0", std::array{3, 5});
    useBus(profile, "socketcan:can0", std::array{5});
    EXPECT_EQ(profile.azimuth.id, 5) << "it answers";
    EXPECT_EQ(profile.mount.directions, Directions::Confirmed);
    expectMakesSense(profile);
}

TEST(Commissioning, SwappedMotorsAreToBeConfirmedAnew)
{
    Profile profile;
    swapMotors(profile);
    EXPECT_EQ(profile.azimuth.id, 2);
    EXPECT_EQ(profile.elevation.id, 1);
    EXPECT_EQ(profile.mount.directions, Directions::Unconfirmed);
    expectMakesSense(profile);
}

TEST(Commissioning, AReversedAxisReadsTheSameAndCountsTheOtherWay)
{
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        Profile profile;
        const MotorTurns here = profile.axis(axis).geometry.toMotor(31.5_deg);
        const MotorTurns on = profile.axis(axis).geometry.toMotor(32.5_deg);
        reverse(profile, axis, 31.5_deg);
        EXPECT_NEAR(profile.axis(axis).geometry.toAxis(here).degrees(), 31.5, 1e-9);
        EXPECT_NEAR(profile.axis(axis).geometry.toAxis(on).degrees(), 30.5, 1e-9);
        EXPECT_EQ(profile.mount.directions, Directions::Unconfirmed);
        expectMakesSense(profile);
    }
    Profile unknown;
    reverse(unknown, Axis::Azimuth, std::nullopt);
    EXPECT_EQ(unknown.azimuth.geometry.sign, -1);
    EXPECT_EQ(unknown.azimuth.geometry.offset, Angle{});
}

TEST(Commissioning, ANarrowerTravelTakesParkAndLimitsInside)
{
    Profile profile;
    profile.park = {.azimuth = 400_deg, .elevation = 80_deg};
    profile.limits.azimuth = {.min = 300_deg, .max = 420_deg};
    setTravel(profile, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    setTravel(profile, Axis::Elevation, {.min = 2_deg, .max = 70_deg});
    EXPECT_EQ(profile.azimuth.geometry.travel, (TravelRange{.min = -10_deg, .max = 270_deg}));
    EXPECT_EQ(profile.limits.azimuth, profile.azimuth.geometry.travel) << "nothing was left of them";
    EXPECT_EQ(profile.park, (AxisPosition{.azimuth = 270_deg, .elevation = 70_deg}));
    EXPECT_EQ(profile.limits.elevation, Profile{}.limits.elevation) << "no limits of operation stay none";
    expectMakesSense(profile);
}

TEST(Commissioning, ANewZeroLeavesCableAndStopsWhereTheyAre)
{
    Profile profile;
    profile.park = {.azimuth = 10_deg, .elevation = 20_deg};
    profile.limits.azimuth = {.min = 0_deg, .max = 360_deg};
    const pointing::AxisGeometry before = profile.azimuth.geometry;
    setReading(profile, Axis::Azimuth, 10_deg, 47.4_deg, Ends::StayOnTheMount);
    const pointing::AxisGeometry& after = profile.azimuth.geometry;
    EXPECT_NEAR(after.toAxis(before.toMotor(10_deg)).degrees(), 47.4, 1e-9);
    for (const Angle end : {before.travel.min, before.travel.max}) {
        EXPECT_TRUE(abs(after.toAxis(before.toMotor(end)) - (end + 37.4_deg)) < kTiny);
    }
    EXPECT_NEAR(after.travel.min.degrees(), -52.6, 1e-9);
    EXPECT_NEAR(after.travel.max.degrees(), 487.4, 1e-9);
    EXPECT_NEAR(profile.limits.azimuth.max.degrees(), 397.4, 1e-9);
    EXPECT_NEAR(profile.park.azimuth.degrees(), 47.4, 1e-9);
    EXPECT_EQ(profile.park.elevation, 20_deg);
    EXPECT_EQ(profile.limits.elevation, Profile{}.limits.elevation);
    expectMakesSense(profile);
}

TEST(Commissioning, ANewZeroOfAReversedMotorCountsTheRightWay)
{
    Profile profile;  // the elevation drive is mounted inverted
    const MotorTurns here = profile.elevation.geometry.toMotor(3.25_deg);
    setReading(profile, Axis::Elevation, 3.25_deg, 0_deg, Ends::KeepTheirNumbers);
    EXPECT_NEAR(profile.elevation.geometry.toAxis(here).degrees(), 0.0, 1e-9);
    EXPECT_EQ(profile.elevation.geometry.travel, Profile{}.elevation.geometry.travel);
    EXPECT_EQ(profile.mount.directions, Directions::Confirmed) << "it turns as before";
    expectMakesSense(profile);
}

TEST(Commissioning, ShiftedEndsAreNumbersThatCanBeRead)
{
    Profile profile;
    setReading(profile, Axis::Azimuth, 10_deg, 10_deg + Angle::fromDegrees(1.0 / 3.0), Ends::StayOnTheMount);
    EXPECT_NEAR(profile.azimuth.geometry.travel.max.degrees(), 450.33, 1e-9);
    expectMakesSense(profile);
}

// REQ-UI-43
TEST(Commissioning, NorthIsSetInThePointingModelAndNoAngleOfAnAxisChanges)
{
    Profile profile;
    const Profile before = profile;
    const AxisPosition axes{.azimuth = 370_deg, .elevation = 20_deg};
    setNorth(profile, axes, 47.4_deg);
    EXPECT_NEAR(profile.pointing.azimuthOffset.degrees(), 37.4, 1e-9);
    profile.pointing = before.pointing;
    EXPECT_EQ(profile, before);
}

// REQ-MOUNT-12
TEST(Commissioning, NorthOfAMountWithOneAxisIsItsZeroAlone)
{
    Profile profile;
    profile.elevation.driver = AxisDriver::None;
    profile.pointing = {.tiltNorth = 2_deg, .collimation = 3_deg};
    setNorth(profile, {.azimuth = 10_deg, .elevation = 0_deg}, 47.4_deg);
    EXPECT_NEAR(profile.pointing.azimuthOffset.degrees(), 37.4, 1e-9);
}

TEST(Commissioning, NorthIsTrueAlsoOnALeaningMastAndOverTheTop)
{
    for (const double elevation : {5.0, 60.0, 130.0}) {
        Profile profile;
        profile.pointing = {.azimuthOffset = 350_deg, .tiltNorth = 2_deg, .tiltEast = -3_deg, .collimation = 1_deg};
        const AxisPosition axes{.azimuth = -25_deg, .elevation = Angle::fromDegrees(elevation)};
        setNorth(profile, axes, 200_deg);
        const SkyPointing now = pointing::upright(pointing::PointingModel(profile.pointing).toSky(axes));
        EXPECT_NEAR(now.azimuth.degrees(), 200.0, 0.006) << elevation;  // two decimals in the file
        EXPECT_LE(abs(profile.pointing.azimuthOffset), 360_deg);
        expectMakesSense(profile);
    }
}

}  // namespace
}  // namespace boresight::profile

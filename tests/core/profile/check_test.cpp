// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of several settings of a profile together: crossCheck() and problemsOf().
#include "tests/core/profile/problem_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace boresight;
using namespace boresight::profile;

// REQ-PROFILE-04: Settings are also checked against each other: min below max, park inside the travel, different ids,
// three ticks within the watchdog time, jog rates in order, jerk not below acceleration per second, hints of the
// supervision before its stops, two ticks within the reply age.
TEST(CrossCheck, FindsEveryClashAtOnce)
{
    Profile profile;
    profile.azimuth.geometry.travel = {.min = 10_deg, .max = 10_deg};
    profile.elevation.geometry.sign = 0;
    profile.park.elevation = 90.5_deg;
    profile.elevation.id = profile.azimuth.id;
    profile.control.tickHz = 20;
    profile.jog.slow = 7_deg_s;
    profile.elevation.limits.jerk = AngularJerk::fromDegrees(7.9);
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"azimuth.travel_min_deg", "elevation.sign", "park.elevation_deg",
                                        "elevation.max_jerk_deg_s3", "elevation.id", "control.watchdog_s",
                                        "jog.normal_deg_s"}));
}

// REQ-PROFILE-967: On an X/Y mount Boresight refuses each setting that it would not obey there: another driver, travel
// beyond half a turn of X or a quarter turn of Y to each side, pointing terms, offsets of antennas, the orientation
// sensor, and a continuous azimuth for clients.
TEST(CrossCheck, AnXYMountHasOnlyWhatItCanDo)
{
    Profile profile;
    profile.pointing.geometry = {.kind = pointing::Geometry::XY, .xAxis = 90_deg};
    profile.azimuth.geometry.travel = {-100_deg, 100_deg};
    profile.elevation.geometry.travel = {-90_deg, 90_deg};
    EXPECT_EQ(keysOf(problemsOf(profile)), std::vector<std::string>{});

    profile.azimuth.driver = AxisDriver::Rotctld;
    profile.azimuth.geometry.travel = {-181_deg, 100_deg};
    profile.elevation.geometry.travel = {-90_deg, 91_deg};
    profile.pointing.azimuthOffset = 1_deg;
    profile.pointing.elevationSag = 0.1_deg;
    profile.antennas = {{.name = "70 cm", .beamWidth = 20_deg}, {.name = "23 cm", .beamWidth = 5_deg, .up = 1_deg}};
    profile.sensor.source = SensorSource::Serial;
    profile.sensor.port = "/dev/ttyUSB0";
    profile.rotctld.azimuth = AzimuthConvention::Continuous;
    EXPECT_EQ(keysOf(problemsOf(profile)),
              (std::vector<std::string>{"azimuth.driver", "azimuth.travel_min_deg", "elevation.travel_max_deg",
                                        "pointing.azimuth_offset_deg", "pointing.elevation_sag_deg",
                                        "antenna[2].offset_across_deg", "sensor.source", "rotctld.azimuth"}));
    profile.pointing.geometry.kind = pointing::Geometry::AzimuthElevation;
    EXPECT_EQ(keysOf(problemsOf(profile)), std::vector<std::string>{});
}

// REQ-PROFILE-966: A rotator has 36 steps in a turn or more, or as many as its box counts. Steps of a driver without
// steps give advice.
TEST(CrossCheck, StepsAreNotTooCoarse)
{
    Profile profile;
    profile.azimuth.stepsPerTurn = 35.0;
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"azimuth.steps_per_turn"}));
    profile.azimuth.stepsPerTurn = 866.0;
    EXPECT_TRUE(crossCheck(profile).empty());
}

// REQ-MOUNT-06: A profile has at least one axis. Boresight knows the driver of each axis, and the two axes may have
// different drivers. The simple rotator, which is only simulated, is refused on a bus. Each driver is refused on a bus
// of the wrong kind.
TEST(CrossCheck, TheDriversOfTheAxesMakeSense)
{
    const auto found = [](AxisDriver azimuth, AxisDriver elevation, const char* bus) {
        Profile profile;
        profile.bus = bus;
        profile.azimuth.driver = azimuth;
        profile.elevation.driver = elevation;
        return keysOf(crossCheck(profile));
    };
    const auto nothing = std::vector<std::string>{};
    const auto only = [](const char* key) { return std::vector<std::string>{key}; };
    EXPECT_EQ(found(AxisDriver::Moteus, AxisDriver::Moteus, "socketcan:can0"), nothing);
    EXPECT_EQ(found(AxisDriver::Simple, AxisDriver::None, "simulated"), nothing);
    EXPECT_EQ(found(AxisDriver::None, AxisDriver::Simple, "simulated"), nothing);
    EXPECT_EQ(found(AxisDriver::Simple, AxisDriver::Simple, "simulated"), nothing);
    EXPECT_EQ(found(AxisDriver::None, AxisDriver::None, "simulated"), only("elevation.driver"));
    EXPECT_EQ(found(AxisDriver::Moteus, AxisDriver::None, "socketcan:can0"), nothing);
    EXPECT_EQ(found(AxisDriver::None, AxisDriver::Moteus, "socketcan:can0"), nothing);
    EXPECT_EQ(found(AxisDriver::Moteus, AxisDriver::Simple, "simulated"), nothing);
    EXPECT_EQ(found(AxisDriver::Simple, AxisDriver::Moteus, "simulated"), nothing);
    const auto onBus = [](AxisDriver azimuth, AxisDriver elevation, const char* bus) {
        Profile profile;
        profile.bus = bus;
        profile.azimuth.driver = azimuth;
        profile.elevation.driver = elevation;
        return keysOf(problemsOfReal(profile));
    };
    EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::Gs232, "serial:/dev/ttyUSB0"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::None, "tcp:10.0.0.7:4001"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::None, "socketcan:can0"), only("bus.name"));
    EXPECT_EQ(onBus(AxisDriver::None, AxisDriver::Moteus, "serial:/dev/ttyUSB0"), only("bus.name"));
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::Rotctld, "rotctld:10.0.0.7:4533"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::None, "rotctld:10.0.0.7:4533"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::Rotctld, "hamlib:901:/dev/ttyUSB0"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::None, "hamlib:603:/dev/ttyUSB0"), only("bus.name"));
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::None, "tcp:10.0.0.7:4533"), only("bus.name"));
    // Story: Boresight connected to its own server, which reported that the mount does not reply.
    for (const char* const own : {"rotctld:127.0.0.1:4533", "rotctld:localhost:4533", "rotctld:[::1]:4533"}) {
        EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::Rotctld, own), only("bus.name")) << own;
    }
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::Rotctld, "rotctld:127.0.0.1:4534"), nothing);
    EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::None, "rotctld:10.0.0.7:4533"), only("bus.name"));
    EXPECT_EQ(onBus(AxisDriver::Moteus, AxisDriver::None, "rotctld:10.0.0.7:4533"), only("bus.name"));
    EXPECT_EQ(onBus(AxisDriver::Rotctld, AxisDriver::Gs232, "rotctld:10.0.0.7:4533"), only("elevation.driver"));
    // Story: with each of the two buses the other axis was refused, and the two texts sent the operator back and forth.
    for (const char* const bus : {"serial:/dev/ttyUSB0", "socketcan:can0", "fdcanusb:/dev/ttyACM0"}) {
        EXPECT_EQ(onBus(AxisDriver::Gs232, AxisDriver::Moteus, bus), only("elevation.driver"));
        EXPECT_EQ(onBus(AxisDriver::Moteus, AxisDriver::Gs232, bus), only("elevation.driver"));
    }
    Profile simple;
    simple.azimuth.driver = AxisDriver::None;
    simple.elevation.driver = AxisDriver::Simple;
    EXPECT_EQ(keysOf(problemsOfReal(simple)), only("elevation.driver"));
    simple.azimuth.driver = AxisDriver::Moteus;
    EXPECT_EQ(keysOf(problemsOfReal(simple)), only("elevation.driver")) << "not even beside a real drive";
}

// REQ-PROFILE-960: A board that is only watched has a name and an id from 1 to 126. No axis and no other watched board
// has the same id.
TEST(CrossCheck, AWatchedBoardHasAnIdOfItsOwn)
{
    Profile profile;
    const Setting& setting = *findSetting("bus.watched");
    for (const char* const bad : {"", "3", "3 ", "0 polarisation", "127 polarisation", "polarisation", "3.5 tilt"}) {
        EXPECT_FALSE(setting.set(profile, TextList{bad})) << bad;
    }
    ASSERT_TRUE(setting.set(profile, TextList{"3 polarisation", "4 second dish"}));
    EXPECT_TRUE(crossCheck(profile).empty());
    ASSERT_TRUE(setting.set(profile, TextList{"3 polarisation", "3 second dish", "2 tilt"}));
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"bus.watched", "bus.watched"}));
    profile.elevation.driver = AxisDriver::None;
    EXPECT_EQ(crossCheck(profile).size(), 1u) << "nothing turns the elevation";
}

// REQ-PROFILE-04
TEST(CrossCheck, AnIdThatNoControllerHasClashesWithNone)
{
    Profile profile;
    profile.elevation.id = profile.azimuth.id;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"elevation.id"});
    profile.elevation.driver = AxisDriver::None;
    EXPECT_TRUE(crossCheck(profile).empty());
}

// REQ-PROFILE-04
TEST(CrossCheck, ThreeTicksMustFitIntoTheWatchdog)
{
    Profile profile;
    profile.control.tickHz = 60;
    profile.control.watchdog = Seconds(0.05);
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.control.tickHz = 59;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"control.watchdog_s"});
}

// REQ-PROFILE-04
TEST(CrossCheck, SupervisionHintsComeBeforeStops)
{
    Profile profile;
    profile.supervision.followingHint = 3.1_deg;
    profile.supervision.outsideHint = 1.6_deg;
    profile.supervision.replyAge = Seconds(0.039);
    profile.supervision.supplyStop = 20.0;
    profile.supervision.supplyHigh = 20.0;
    profile.supervision.boardHot = 75.0;
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"supervision.following_hint_deg", "supervision.outside_hint_deg",
                                        "supervision.reply_age_s", "supervision.supply_stop_v",
                                        "supervision.supply_low_v", "supervision.board_hot_c"}));
}

// REQ-PROFILE-05: The operating limits overlap the travel. Points of the horizon ascend, each azimuth once. Names of
// keep-outs and presets are unique. At most 3600 points and 32 keep-outs are allowed. The mount parks where limits,
// horizon and keep-outs permit it.
TEST(CrossCheck, LimitsLeaveSomethingOfTheTravel)
{
    Profile profile;
    profile.limits.azimuth = {.min = 450_deg, .max = 500_deg};
    profile.limits.elevation = {.min = 20_deg, .max = 20_deg};
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"limits.azimuth_min_deg", "limits.elevation_min_deg"}));
    profile.limits.azimuth = {.min = -100_deg, .max = 500_deg};
    profile.limits.elevation = {.min = -5_deg, .max = 0.1_deg};
    EXPECT_TRUE(crossCheck(profile).empty()) << "as much as is left of the travel counts";
}

// REQ-PROFILE-05
TEST(CrossCheck, TheMountParksWhereItMayBe)
{
    Profile profile;
    profile.limits.azimuth = {.min = 0.1_deg, .max = 500_deg};
    profile.limits.elevation = {.min = -5_deg, .max = 30_deg};
    profile.park.elevation = 30.1_deg;
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"park.azimuth_deg", "park.elevation_deg"}));
    profile.park = {.azimuth = 0.1_deg, .elevation = 30_deg};
    EXPECT_TRUE(crossCheck(profile).empty());

    profile.limits.horizon = {{0_deg, 30.5_deg}};
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"park.elevation_deg"});
    profile.limits.horizon = {{0_deg, 5_deg}};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.limits.keepOuts = {{"mast", 350_deg, 10_deg, 20_deg, 40_deg}};
    const auto problems = crossCheck(profile);
    ASSERT_EQ(keysOf(problems), std::vector<std::string>{"park.elevation_deg"});
    EXPECT_NE(problems.front().text.toStdString().find("lies in keep-out \"mast\""), std::string::npos)
        << problems.front().text.toStdString();
    profile.limits.keepOuts.front().elevationMin = 30_deg;
    EXPECT_TRUE(crossCheck(profile).empty()) << "its edge is permitted";
}

// Parked at an axis angle of 0°, the beam points to 37.4°, where the mast is.
// REQ-PROFILE-05a
TEST(CrossCheck, TheMountParksWhereTheBeamMayBe)
{
    Profile profile;
    profile.limits.keepOuts = {{"mast", 30_deg, 45_deg, 0_deg, 40_deg}};
    profile.park = {.azimuth = 0_deg, .elevation = 20_deg};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.pointing.azimuthOffset = 37.4_deg;
    const auto problems = crossCheck(profile);
    ASSERT_EQ(keysOf(problems), std::vector<std::string>{"park.elevation_deg"});
    EXPECT_EQ(problems.front().text.toStdString(), "37.4° / 20.0° lies in keep-out \"mast\"");
    EXPECT_EQ(problems.front().advice.toStdString(), "Permitted: azimuth axis 0.00°, elevation 40.00°.");
}

TEST(CrossCheck, AHorizonHasNoMorePointsThanCanBeChecked)
{
    Profile profile;
    for (int i = 0; i < 3600; ++i) {
        profile.limits.horizon.push_back({Angle::fromDegrees(0.1 * i), -90_deg});
    }
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.limits.horizon.push_back({359.95_deg, -90_deg});
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"limits.horizon"});
}

// REQ-PROFILE-05
TEST(CrossCheck, RowsMakeSenseTogether)
{
    Profile profile;
    profile.limits.horizon = {{10_deg, -5_deg}, {10_deg, -4_deg}, {5_deg, -5_deg}, {90_deg, -5_deg}};
    profile.limits.keepOuts = {{"mast", 350_deg, 10_deg, 40_deg, 40_deg}, {"mast", 20_deg, 20_deg, 40_deg, 50_deg}};
    profile.presets = {{"a", {}}, {"b", {}}, {"a", {}}};
    EXPECT_EQ(
        keysOf(crossCheck(profile)),
        (std::vector<std::string>{"limits.horizon[2]", "limits.horizon[3]", "keep_out[2].name",
                                  "keep_out[1].elevation_min_deg", "keep_out[2].azimuth_to_deg", "preset[3].name"}));
}

// REQ-SCHEDULE-904: The watch list of the profile has each satellite once, by its number. Unless the profile says
// otherwise, the schedule waits for a person, and goes to the start of a pass at least 60 s before the pass.
TEST(CrossCheck, TheWatchListHasEachSatelliteOnce)
{
    Profile profile;
    EXPECT_EQ(profile.schedule.unattended, Unattended::Off);
    EXPECT_EQ(findSetting("schedule.lead_s")->min, 60.0);
    profile.schedule.watch = {{.number = 25544}, {.number = 33591}};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.schedule.watch = {{.number = 25544}, {}, {.number = 25544}};
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"watch[2].norad", "watch[3].norad"}));
}

// REQ-ANTENNA-920: The antennas of a profile have different names, and none has the name of the main antenna. A
// satellite may name one of them. Another name is refused with the list of names and what to do.
TEST(CrossCheck, ASatelliteNamesAnAntennaOfTheProfile)
{
    Profile profile;
    profile.antennas = {{.name = "70 cm"}, {.name = "2 m"}};
    profile.satellites = {{.number = 25544, .note = {}, .antenna = "2 m"},
                          {.number = 33591, .note = {}, .antenna = "main"},
                          {.number = 7, .note = {}}};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.satellites[1].antenna = "23 cm";
    const auto unknown = crossCheck(profile);
    ASSERT_EQ(unknown.size(), 1U);
    EXPECT_EQ(unknown[0].key, "satellite[2].antenna");
    EXPECT_EQ(unknown[0].text,
              QStringLiteral("There is no antenna \"23 cm\". Name one of \"main\", \"70 cm\", \"2 m\", "
                             "or add [[antenna]] with this name."));
    profile.satellites.clear();
    profile.antennas = {{.name = "2 m"}, {.name = "main"}, {.name = "2 m"}};
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"antenna[2].name", "antenna[3].name"}));
    profile.antennas.clear();
    for (int i = 0; i < 13; ++i) {
        profile.antennas.push_back({.name = std::to_string(i)});
    }
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"antenna"});
}

// REQ-PASSES-959: The profile keeps favourites and notes of satellites, each satellite once. A note is one line of at
// most 120 characters.
TEST(CrossCheck, TheMarksHaveEachSatelliteOnce)
{
    Profile profile;
    profile.satellites = {{.number = 25544, .note = {}}, {.number = 33591, .note = {}}};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.satellites = {{.number = 25544, .note = {}}, {}, {.number = 25544, .note = {}}};
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"satellite[2].norad", "satellite[3].norad"}));
}

TEST(Check, ANoteIsOneShortLine)
{
    const auto isGood = [](const std::string& note) {
        Profile profile;
        profile.satellites = {{.number = 25544, .note = note}};
        return problemsOf(profile).empty();
    };
    EXPECT_TRUE(isGood("435.350 MHz GMSK, à direita"));
    std::string longest;
    for (std::size_t i = 0; i < orbit::kLongestNote; ++i) {
        longest += "é";
    }
    EXPECT_TRUE(isGood(longest)) << "characters are counted, not bytes";
    EXPECT_FALSE(isGood(longest + "é"));
    EXPECT_FALSE(isGood("two\nlines"));
}

// The screen makes profiles without reading a file. A profile that could not be read again must not be applied.
// REQ-PROFILE-08
TEST(ProblemsOf, CountRangesToo)
{
    Profile profile;
    EXPECT_TRUE(problemsOf(profile).empty());
    profile.mount.name = "two\nlines";
    profile.site.latitude = 91_deg;  // does not count while the site is unknown
    profile.limits.horizon = {{0_deg, 0_deg}, {359.9999999_deg, -90.5_deg}};
    profile.limits.keepOuts = {{"", 350_deg, 10_deg, 40_deg, 90_deg}};
    profile.presets = {{"zenith", {0_deg, 180.5_deg}}};
    profile.jog.slow = 3_deg_s;
    EXPECT_EQ(
        keysOf(problemsOf(profile)),
        (std::vector<std::string>{"mount.name", "limits.horizon[2].azimuth_deg", "limits.horizon[2].elevation_deg",
                                  "keep_out[1].name", "preset[1].elevation_deg", "jog.normal_deg_s"}));
    profile.site.known = true;
    EXPECT_EQ(problemsOf(profile).size(), 7U);
}

// REQ-PROFILE-05
TEST(CrossCheck, KeepOutsHaveAMaximum)
{
    Profile profile;
    for (std::size_t i = 0; i < kMaxKeepOuts; ++i) {
        profile.limits.keepOuts.push_back({std::to_string(i), 100_deg, 110_deg, 40_deg, 50_deg});
    }
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.limits.keepOuts.push_back({"one more", 100_deg, 110_deg, 40_deg, 50_deg});
    const auto problems = crossCheck(profile);
    ASSERT_EQ(keysOf(problems), std::vector<std::string>{"keep_out"});
    EXPECT_EQ(problems.front().text.toStdString(), "33 keep-outs are too many. The maximum is 32.");
}

// REQ-PROFILE-05b: Keep-away from the Sun needs the site.
TEST(CrossCheck, TheSunNeedsTheSite)
{
    Profile profile;
    EXPECT_EQ(profile.sun.keepAway, KeepAway::Off) << "by choice";
    profile.sun.keepAway = KeepAway::On;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"sun.keep_away"});
    profile.site.known = true;
    EXPECT_TRUE(crossCheck(profile).empty());
}

// REQ-PROFILE-04
TEST(CrossCheck, TwoTicksMustFitIntoTheReplyAge)
{
    Profile profile;
    profile.control.tickHz = 20;
    profile.control.watchdog = Seconds(0.2);
    EXPECT_TRUE(crossCheck(profile).empty()) << "0.1 s are 2 ticks of 20 Hz";
    profile.supervision.replyAge = Seconds(0.099);
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"supervision.reply_age_s"});
}

// REQ-THIRD-40: A third axis needs a moteus on the same bus, an id of its own, limits that leave a travel, and a travel
// within the one turn that its board knows after power-up. Without an id nothing of it is checked.
TEST(CrossCheck, FindsAnImpossibleThirdAxis)
{
    Profile profile;
    profile.thirdAxis.axis.geometry.travel = {.min = 90_deg, .max = 90_deg};
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.thirdAxis.axis.id = 2;
    profile.thirdAxis.axis.geometry.sign = 0;
    profile.thirdAxis.axis.limits.jerk = AngularJerk::fromDegrees(1.0);
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"third_axis.id", "third_axis.sign", "third_axis.max_jerk_deg_s3",
                                        "third_axis.travel_max_deg"}));
    profile.thirdAxis = {};
    profile.thirdAxis.axis.id = 3;
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.watchedBoards = {"3 polarisation"};
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"third_axis.id"}));
    profile.watchedBoards.clear();
    profile.thirdAxis.axis.geometry.travel = {.min = 0_deg, .max = 270_deg};
    EXPECT_EQ(keysOf(crossCheck(profile)), (std::vector<std::string>{"third_axis.travel_max_deg"}));
    profile.thirdAxis.axis.geometry.offset = -135_deg;
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.azimuth.driver = AxisDriver::Simple;
    profile.elevation.driver = AxisDriver::Simple;
    const auto keys = keysOf(crossCheck(profile));
    EXPECT_NE(std::ranges::find(keys, "third_axis.id"), keys.end());
}

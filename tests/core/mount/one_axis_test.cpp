// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/almanac.h"
#include "tests/core/mount/mount_bench.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace boresight {
namespace {

using profile::AxisDriver;

// REQ-MOUNT-03: A mount with one axis needs no reply, no wrap and no arming of the other axis. The other axis is shown
// as missing and cannot be jogged. Targets for it are ignored, and 0 is reported for it.
TEST(OneAxis, WhatIsAskedOfTheMissingAxisIsIgnored)
{
    for (const Axis missing : kAxes) {
        SimpleBench bench({.azimuth = missing != Axis::Azimuth, .elevation = missing != Axis::Elevation});
        bench.run(Seconds(1.0));
        const AxisPosition before = bench.truth();
        ASSERT_TRUE(bench.ask(request::PointAxes{{120_deg, 40_deg}}));
        bench.run(Seconds(30.0));
        bench.expectAt({120_deg, 40_deg}, before, bench.resolution() / 2.0);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        const SkyPointing direction = bench.control().direction().value_or(SkyPointing{-1_deg, -1_deg});
        EXPECT_EQ(missing == Axis::Azimuth ? direction.azimuth : direction.elevation, 0_deg);
        EXPECT_NEAR(missing == Axis::Azimuth ? direction.elevation.degrees() : direction.azimuth.degrees(),
                    missing == Axis::Azimuth ? 40.0 : 120.0, 1e-6);
    }
}

// REQ-MOUNT-10: For an axis without a moteus no query or command is sent, and no value is stored or believed, even if a
// drive replies under its id. The crash-stop test uses the other axis.
TEST(OneAxis, NothingOfADriveUnderTheIdOfTheMissingAxisCounts)
{
    StationRig foreign;  // has drives for both axes
    foreign.run(Seconds(0.1));
    for (const Axis missing : kAxes) {
        const bool azimuth = missing != Axis::Azimuth;
        const Axis there = azimuth ? Axis::Azimuth : Axis::Elevation;
        MoteusBench bench(slowProfile(azimuth ? AxisDriver::Moteus : AxisDriver::None,
                                      azimuth ? AxisDriver::None : AxisDriver::Moteus));
        StationRig& rig = bench.rig();
        const AxisPosition before = bench.truth();
        bench.run(Seconds(1.0));
        ASSERT_TRUE(bench.goTo(120.0, 40.0));
        for (int i = 0; i < 1500; ++i) {
            bench.tick();
            const auto frames = rig.mount.frames();
            ASSERT_EQ(frames.size(), 1U);
            ASSERT_EQ(moteus::fromCanId(frames.front().id).destination, rig.profile.axis(there).id);
            const CanFrame question = foreign.mount.frames()[index(missing)];
            rig.mount.take(foreign.drive(missing).answer(question, rig.clock.now()).value());
        }
        EXPECT_TRUE(rig.drive(missing).seen.empty());
        bench.expectAt({120_deg, 40_deg}, before, bench.resolution());
        EXPECT_EQ(rig.mount.report(missing).place, 0_deg);
        EXPECT_FALSE(rig.mount.journal().turns[index(missing)]);
        EXPECT_TRUE(rig.mount.journal().turns[index(there)]);
        EXPECT_FALSE(rig.mount.chooseWrap(missing, 0_deg, QStringLiteral("operator")));
        const DrivesStatus drives = *rig.control.status().drives;
        EXPECT_EQ(drives.azimuth.present, azimuth);
        EXPECT_EQ(drives.elevation.present, !azimuth);
    }
}

// REQ-MOUNT-10
TEST(OneAxis, TheCrashStopOfItIsProvenAlone)
{
    MoteusBench bench(slowProfile(AxisDriver::None, AxisDriver::Moteus));
    StationRig& rig = bench.rig();
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(0.0, 45.0));
    bench.run(Seconds(15.0));
    const Result<> proving = bench.ask(request::ProveCrashStop{AngularRate::fromDegrees(2.0)});
    ASSERT_TRUE(proving) << textOf(proving.error());
    bench.run(Seconds(10.0));
    EXPECT_FALSE(rig.mount.proofRunning());
    const DrivesStatus drives = *rig.control.status().drives;
    EXPECT_EQ(drives.proofText, QStringLiteral("done"));
    EXPECT_FALSE(drives.azimuth.crashStop);
    EXPECT_TRUE(drives.elevation.crashStop);
    EXPECT_TRUE(rig.drive(Axis::Azimuth).seen.empty());
}

// REQ-MOUNT-03
TEST(OneAxis, TheMissingAxisIsShownAsMissingAndCanNotBeJogged)
{
    SimpleBench bench({.azimuth = true, .elevation = false});
    bench.run(Seconds(1.0));
    const StationStatus status = bench.control().status();
    EXPECT_EQ(status.elevation.state, AxisState::Missing);
    EXPECT_NE(status.azimuth.state, AxisState::Missing);
    EXPECT_FALSE(status.capabilities.has(Axis::Elevation));
    EXPECT_EQ(status.permissions.reason(Action::JogUp), QStringLiteral("This mount has no elevation axis."));
    EXPECT_EQ(status.permissions.reason(Action::StepDown), QStringLiteral("This mount has no elevation axis."));
    EXPECT_TRUE(status.permissions.allows(Action::JogLeft)) << status.permissions.reason(Action::JogLeft).toStdString();
}

// REQ-MOUNT-04: The other angle of the beam of a mount with one axis is unknown. So a keep-out applies to all values of
// the missing angle, and no horizon limits an azimuth.
TEST(OneAxis, AKeepOutHoldsForTheWholeOfTheMissingAngle)
{
    profile::Profile profile = slowProfile();
    profile.limits.horizon = {{.azimuth = 0_deg, .elevation = 15_deg}};
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 80_deg, .azimuthTo = 100_deg, .elevationMin = 20_deg, .elevationMax = 40_deg}};
    SimpleBench bench({.azimuth = true, .elevation = false}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(90.0, 0.0));
    ASSERT_TRUE(bench.goTo(60.0, 0.0));
    bench.run(Seconds(20.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 60.0, 0.5);
    ASSERT_TRUE(bench.ask(request::Move{{.azimuth = AngularRate::fromDegrees(5.0)}}));
    bench.run(Seconds(10.0));
    EXPECT_LE(bench.truth().azimuth, 80.5_deg);
    EXPECT_GE(bench.truth().azimuth, 79_deg) << "it went that far";
}

// REQ-MOUNT-04
TEST(OneAxis, AKeepOutHoldsAtAllAzimuthsWithoutOne)
{
    profile::Profile profile = slowProfile();
    profile.limits.keepOuts = {
        {.name = "wire", .azimuthFrom = 80_deg, .azimuthTo = 100_deg, .elevationMin = 50_deg, .elevationMax = 55_deg}};
    SimpleBench bench({.azimuth = false, .elevation = true}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(0.0, 52.0));
    EXPECT_FALSE(bench.goTo(0.0, 80.0)) << "there is no way around it";
    EXPECT_TRUE(bench.goTo(0.0, 45.0));
}

// Story: "Go here" was refused by the limits of an elevation that the mount does not have.
// REQ-MOUNT-04
TEST(OneAxis, ADirectionIsJudgedByTheAxisThatIsThere)
{
    profile::Profile profile = slowProfile();
    profile.limits.horizon = {{.azimuth = 0_deg, .elevation = 15_deg}};
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 80_deg, .azimuthTo = 100_deg, .elevationMin = 20_deg, .elevationMax = 40_deg}};
    SimpleBench both({.azimuth = true, .elevation = true}, profile);
    SimpleBench one({.azimuth = true, .elevation = false}, profile);
    for (SimpleBench* const bench : {&both, &one}) {
        bench->run(Seconds(1.0));
    }
    EXPECT_EQ(both.control().judge({90_deg, 60_deg}).whyNot, QString());
    EXPECT_NE(both.control().judge({60_deg, 10_deg}).whyNot, QString()) << "below the horizon";
    EXPECT_TRUE(one.control().judge({90_deg, 60_deg}).whyNot.contains(QStringLiteral("mast")));
    EXPECT_EQ(one.control().judge({60_deg, 10_deg}).whyNot, QString());
}

// Lisbon. The beam stays 10° away from the Sun.
profile::Profile sunnyProfile()
{
    profile::Profile profile = slowProfile();
    profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    profile.sun = {.keepAway = profile::KeepAway::On, .radius = 10_deg};
    return profile;
}

bool warnsNow(Bench& bench, const char* alarm)
{
    return std::ranges::any_of(bench.control().status().alarms,
                               [alarm](const Alarm& one) { return one.active && one.name == QLatin1String(alarm); });
}

// Story: a mount with an azimuth only pointed towards the Sun all noon. No alarm was raised, because its elevation
// counted as 0°.
// REQ-MOUNT-11: The Sun may be in the beam of a mount with one axis as soon as the known angle is within the keep-out
// of the Sun. An advisory reports this as a possibility, because the other angle is unknown.
TEST(OneAxis, TheSunMayBeInTheBeamWhereTheAngleThatIsKnownIsNear)
{
    const Site lisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    constexpr std::chrono::hours kAfternoon{16};
    for (const Axis missing : kAxes) {
        for (const double away : {0.0, 40.0}) {
            SimpleBench bench({.azimuth = missing != Axis::Azimuth, .elevation = missing != Axis::Elevation},
                              sunnyProfile());
            bench.run(Seconds(1.0));
            ephemeris::Almanac almanac(lisbon);
            const SkyPointing sun = almanac.place(ephemeris::Body::Sun, bench.clock().utc() + kAfternoon).direction;
            ASSERT_TRUE(bench.goTo(sun.azimuth.degrees() - away, sun.elevation.degrees() + away));
            bench.run(Seconds(60.0));
            EXPECT_FALSE(warnsNow(bench, "sun.near-one-axis")) << "at night";
            bench.clock().stepUtc(kAfternoon);
            bench.run(Seconds(0.1));
            EXPECT_EQ(warnsNow(bench, "sun.near-one-axis"), away == 0.0) << index(missing);
            EXPECT_FALSE(warnsNow(bench, "sun.near")) << "nobody knows that";
            bench.clock().stepUtc(kAfternoon / 2);
            bench.run(Seconds(0.1));
            EXPECT_FALSE(warnsNow(bench, "sun.near-one-axis")) << "the Sun is down";
        }
    }
}

// REQ-MOUNT-11
TEST(OneAxis, WithoutAClockTheSunMayBeAtAnyOfTheMissingAngle)
{
    SimpleBench bench({.azimuth = true, .elevation = false}, sunnyProfile());
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(180.0, 0.0)) << "at night";
    bench.run(Seconds(60.0));
    bench.clock().setSynchronised(false);
    bench.clock().setUtc(std::chrono::sys_days{std::chrono::year{2000} / 1 / 1});
    bench.run(Seconds(1.0));
    const Result<> asked = bench.goTo(200.0, 0.0);
    ASSERT_FALSE(asked) << "at the horizon in the south the Sun never stands, but higher it does";
    EXPECT_NE(textOf(asked.error()).find("Only the operator may jog the mount out"), std::string::npos)
        << textOf(asked.error());
}

// REQ-MOUNT-12: For a mount with one axis only those terms of the pointing model count that need no missing angle: its
// zero, and the sag of an elevation.
TEST(OneAxis, WhatOneAngleChangesByTheOtherDoesNotCount)
{
    profile::Profile profile = slowProfile();
    profile.pointing = {.azimuthOffset = 30_deg, .elevationOffset = 5_deg, .tiltNorth = 4_deg, .collimation = 3_deg};
    for (const Axis missing : kAxes) {
        SimpleBench bench({.azimuth = missing != Axis::Azimuth, .elevation = missing != Axis::Elevation}, profile);
        bench.run(Seconds(1.0));
        const AxisPosition before = bench.truth();
        ASSERT_TRUE(bench.ask(request::PointSky{{.azimuth = 120_deg, .elevation = 45_deg}}));
        bench.run(Seconds(30.0));
        bench.expectAt({90_deg, 40_deg}, before, bench.resolution() / 2.0);
        const SkyPointing expected = missing == Axis::Azimuth ? SkyPointing{.azimuth = 0_deg, .elevation = 45_deg}
                                                              : SkyPointing{.azimuth = 120_deg, .elevation = 0_deg};
        const StationStatus status = bench.control().status();
        ASSERT_TRUE(status.actual && status.azimuth.beam.actual && status.elevation.beam.actual);
        EXPECT_NEAR(status.actual->azimuth.degrees(), expected.azimuth.degrees(), 1e-6);
        EXPECT_NEAR(status.actual->elevation.degrees(), expected.elevation.degrees(), 1e-6);
        EXPECT_NEAR(status.azimuth.beam.actual->degrees(), expected.azimuth.degrees(), 1e-6);
        EXPECT_NEAR(status.elevation.beam.actual->degrees(), expected.elevation.degrees(), 1e-6);
    }
}

// REQ-MOUNT-13: The texts of a mount are right for a mount with one axis and for a mount without a time-out mode.
TEST(OneAxis, ARotatorWithoutTimeOutModeIsNotSaidToHaveOne)
{
    SimpleBench bench;
    bench.run(Seconds(1.0));
    EXPECT_EQ(bench.control().status().azimuth.stateText, QStringLiteral("holds by itself"));
}

// REQ-MOUNT-13
TEST(OneAxis, OfARotatorThatHasNeverAnsweredNoWrapIsUnknown)
{
    SimpleBench bench;
    bench.setLine(false);
    bench.run(Seconds(1.0));
    const AxisStatus azimuth = bench.control().status().azimuth;
    EXPECT_FALSE(azimuth.actual);
    EXPECT_EQ(azimuth.stateText, QString());
}

}  // namespace
}  // namespace boresight

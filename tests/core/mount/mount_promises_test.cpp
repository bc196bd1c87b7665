// SPDX-License-Identifier: GPL-3.0-or-later
// The promises of every rotator behind the port of the mount, tested with the control above it.
#include "tests/core/gs232_mount/esp32_bench.h"
#include "tests/core/gs232_mount/gs232_bench.h"
#include "tests/core/mount/mount_bench.h"
#include "tests/core/rotctld_mount/rotctld_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

namespace boresight {
namespace {

using profile::AxisDriver;

struct Kind
{
    const char* name;
    std::function<std::unique_ptr<Bench>()> make;
};

// REQ-MOUNT-01 (MountPromises.*): Every driver behind the port of the mount keeps the same promises. Opening the driver
// moves nothing. The first command holds the measured position. Limits hold. STOP works and latches. Silence is
// reported within the time that the driver states in its capabilities. Nothing moves after a fault without a re-arm. A
// target counts as reached within the accuracy of the rotator. A rotator without a watchdog is reported once, and the
// operator can acknowledge that.
class MountPromises : public testing::TestWithParam<Kind>
{
protected:
    std::unique_ptr<Bench> bench = GetParam().make();
};

TEST_P(MountPromises, OpeningMovesNothing)
{
    const AxisPosition before = bench->truth();
    bench->run(Seconds(3.0));
    EXPECT_FALSE(bench->ordered());
    EXPECT_EQ(bench->truth(), before);
    EXPECT_EQ(bench->control().state(), StationState::Standby);
}

// Only a mount with a service for its drives reports what can be read and set in them.
TEST_P(MountPromises, OnlyAMountWithAServiceReportsItsDrives)
{
    bench->run(Seconds(1.0));
    const StationStatus status = bench->control().status();
    EXPECT_EQ(status.drives.has_value(), bench->control().mount().service() != nullptr);
    EXPECT_TRUE(status.azimuth.turnKnown);
    EXPECT_TRUE(status.elevation.turnKnown);
}

TEST_P(MountPromises, TheFirstCommandHoldsWhatWasMeasured)
{
    bench->run(Seconds(1.0));
    const AxisPosition before = bench->truth();
    const AxisPosition measured = *bench->control().mount().measured();
    ASSERT_TRUE(bench->ask(request::PointAxes{measured}));
    bench->run(Seconds(2.0));
    bench->expectAt(before, before, bench->resolution() / 2.0);
}

TEST_P(MountPromises, GoesWhereItIsSent)
{
    bench->run(Seconds(1.0));
    const AxisPosition before = bench->truth();
    ASSERT_TRUE(bench->goTo(60.0, 45.0));
    bench->run(Seconds(25.0));
    bench->expectAt({60_deg, 45_deg}, before, bench->resolution());
}

// Story: a rotator with whole degrees kept slewing for ever to a target between two degrees.
TEST_P(MountPromises, APlaceBetweenItsStepsCountsAsReached)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(60.5, 45.4));
    bench->run(Seconds(3.0));
    EXPECT_EQ(bench->control().state(), StationState::Slew);
    bench->run(Seconds(22.0));
    EXPECT_EQ(bench->control().state(), StationState::Hold);
}

TEST_P(MountPromises, LimitsHold)
{
    bench->run(Seconds(1.0));
    const Axis axis = bench->someAxis();
    const StationStatus status = bench->control().status();
    const Angle end = axis == Axis::Azimuth ? status.azimuth.travel.min : status.elevation.travel.min;
    const double outside = end.degrees() - 5.0;
    EXPECT_FALSE(axis == Axis::Azimuth ? bench->goTo(outside, 45.0) : bench->goTo(60.0, outside))
        << "a place outside is refused";
    const AngularRate down = AngularRate::fromDegrees(-5.0);
    ASSERT_TRUE(
        bench->ask(request::Move{axis == Axis::Azimuth ? AxisRates{.azimuth = down} : AxisRates{.elevation = down}}));
    for (int i = 0; i < 1500; ++i) {
        bench->tick();
        ASSERT_GE(of(axis, bench->truth()), end - bench->resolution() / 2.0);
    }
    EXPECT_LE(of(axis, bench->truth()), end + bench->resolution()) << "it went that far";
}

TEST_P(MountPromises, StopWorksAndLatches)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    ASSERT_TRUE(bench->ask(request::Stop{}));
    bench->run(Seconds(2.0));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
    EXPECT_LT(bench->truth().azimuth, 60_deg) << "far from where it was sent";
    EXPECT_LT(bench->truth().elevation, 55_deg);
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
    ASSERT_TRUE(bench->ask(request::ResetStop{}));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
}

TEST_P(MountPromises, SilenceIsReportedInItsOwnTime)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->setLine(false);
    bench->run(bench->silence() + Seconds(0.1));
    EXPECT_EQ(bench->control().state(), StationState::Disconnected);
    EXPECT_TRUE(bench->control().faultLatched());
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
}

TEST_P(MountPromises, NothingMovesAfterAFaultWithoutARearm)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->setLine(false);
    bench->run(Seconds(2.0));
    bench->setLine(true);
    bench->run(Seconds(1.0));
    EXPECT_TRUE(bench->stands(Seconds(5.0)));
    EXPECT_EQ(bench->control().state(), StationState::Fault);
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
    ASSERT_TRUE(bench->ask(request::Rearm{}));
    bench->run(Seconds(1.0));
    EXPECT_TRUE(bench->stands(Seconds(3.0))) << "a re-arm moves nothing either";
}

// REQ-MOUNT-600: A mount that its driver reports as unfit receives no motion command. The refusal gives the reason. A
// motion under way ends, and does not resume by itself when the mount is fit again.
TEST_P(MountPromises, AnUnfitMountIsNeverOrderedAndSaysWhy)
{
    bench->run(Seconds(1.0));
    EXPECT_TRUE(bench->control().mount().interlock());
    if (!bench->setFit(false)) {
        return;
    }
    const AxisPosition before = bench->truth();
    for (const auto& refused : {bench->goTo(60.0, 45.0), bench->ask(request::Move{{.azimuth = 1_deg_s}}),
                                bench->ask(request::Move{{.elevation = 1_deg_s}})}) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().text, kUnfit);
    }
    bench->run(Seconds(3.0));
    EXPECT_FALSE(bench->ordered());
    EXPECT_EQ(bench->truth(), before);

    ASSERT_TRUE(bench->setFit(true));
    ASSERT_TRUE(bench->goTo(60.0, 45.0));
    bench->run(Seconds(25.0));
    bench->expectAt({60_deg, 45_deg}, before, bench->resolution());
}

// REQ-MOUNT-600
TEST_P(MountPromises, AMountThatBecomesUnfitEndsItsMotion)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    if (!bench->setFit(false)) {
        bench->run(Seconds(25.0));
        EXPECT_TRUE(bench->control().mount().interlock()) << "it is fit also in motion";
        return;
    }
    bench->run(Seconds(2.0));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
    EXPECT_LT(bench->truth().azimuth, 60_deg) << "far from where it was sent";
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
    ASSERT_TRUE(bench->setFit(true));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
    EXPECT_TRUE(bench->goTo(90.0, 60.0));
}

// REQ-MOUNT-601: A device that replaced another one is sent nowhere before the operator has entered its position. A
// device that does not report its identity has none in the report.
TEST_P(MountPromises, AnotherDeviceIsNeverOrdered)
{
    bench->run(Seconds(1.0));
    bench->setLine(false);
    bench->run(Seconds(2.0));
    if (!bench->exchangeDevice()) {
        bench->setLine(true);
        bench->run(Seconds(2.0));
        EXPECT_EQ(bench->control().mount().identity(bench->someAxis()), QString());
        return;
    }
    bench->setLine(true);
    bench->run(Seconds(2.0));
    const AxisPosition before = bench->truth();
    EXPECT_FALSE(bench->goTo(60.0, 45.0));
    bench->run(Seconds(3.0));
    EXPECT_FALSE(bench->ordered());
    EXPECT_EQ(bench->truth(), before);
}

TEST_P(MountPromises, TheEndOfTheProgramLeavesItStanding)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->control().shutDown();
    for (int i = 0; i < 500 && !bench->control().shutDownDone(); ++i) {
        bench->tick();
    }
    ASSERT_TRUE(bench->control().shutDownDone());
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
}

// REQ-BRAKE-31: Every rotator stands still until its brake is open, and before its brake is set.
TEST_P(MountPromises, MovesOnlyWhileItsBrakeIsOpen)
{
    profile::Profile braked = *bench->inForce();
    braked.brake = {.output = "rts:/dev/ttyUSB0", .switching = Seconds(0.5), .setAfter = Seconds(2.0)};
    bench->edit(braked);
    const auto runAs = [this](Seconds time, bool open) {
        for (Seconds left = time; left > Seconds(0.0); left -= kOneTick) {
            const bool isReleased = bench->control().releasesBrake();
            bench->control().takeBrake({.isOn = isReleased});
            const AxisPosition before = bench->truth();
            bench->tick();
            EXPECT_TRUE(isReleased || bench->truth() == before);
            EXPECT_TRUE(open || bench->truth() == before);
        }
    };
    runAs(Seconds(1.0), false);
    const AxisPosition before = bench->truth();
    ASSERT_TRUE(bench->goTo(60.0, 45.0));
    runAs(Seconds(0.5), false);
    runAs(Seconds(25.0), true);
    bench->expectAt({60_deg, 45_deg}, before, bench->resolution());
    EXPECT_FALSE(bench->control().releasesBrake());
    ASSERT_TRUE(bench->goTo(30.0, 20.0));
    runAs(Seconds(4.0), true);
    EXPECT_TRUE(bench->control().releasesBrake());
    ASSERT_TRUE(bench->ask(request::Stop{}));
    runAs(Seconds(8.0), true);
    EXPECT_FALSE(bench->control().releasesBrake());
    runAs(Seconds(5.0), false);
}

TEST_P(MountPromises, AMissingWatchdogIsShownOnceAndCanBeAcknowledged)
{
    bench->run(Seconds(1.0));
    const bool watchdog =
        std::ranges::all_of(bench->can().axes, [](const auto& axis) { return !axis || axis->watchdog; });
    EXPECT_EQ(bench->warns("mount.no-watchdog"), !watchdog);
    ASSERT_TRUE(bench->ask(request::AcknowledgeAlarms{}));
    bench->run(Seconds(5.0));
    for (const Alarm& alarm : bench->control().status().alarms) {
        EXPECT_TRUE(alarm.acknowledged) << alarm.name.toStdString();
    }
}

std::unique_ptr<Bench> simpleBench(bool azimuth, bool elevation)
{
    return std::make_unique<SimpleBench>(SimpleMount::Axes{.azimuth = azimuth, .elevation = elevation});
}

std::unique_ptr<Bench> moteusBench(AxisDriver azimuth, AxisDriver elevation)
{
    return std::make_unique<MoteusBench>(slowProfile(azimuth, elevation));
}

// REQ-ENDSWITCH-30: Every rotator stops before it is 8° beyond the place where its end switch was pressed, and does not
// move further into this end. The way back is open after the re-arm.
TEST_P(MountPromises, StopsAtItsEndSwitch)
{
    const Axis axis = bench->someAxis();
    profile::Profile profile = *bench->inForce();
    profile.endSwitches.inputs.at(end_switches::indexOf({axis, true})) = "mqtt:end";
    bench->edit(profile);
    EndSwitchGuard::Readings readings;
    const auto run = [&](bool isPressed, Seconds time) {
        readings.fill({.isOn = !isPressed});
        for (Seconds left = time; left > Seconds(0.0); left -= kOneTick) {
            bench->control().takeEndSwitches(readings);
            bench->tick();
        }
    };
    const auto jog = [&](double rate) {
        const AngularRate wanted = AngularRate::fromDegrees(rate);
        return bench->ask(
            request::Move{axis == Axis::Azimuth ? AxisRates{.azimuth = wanted} : AxisRates{.elevation = wanted}});
    };
    run(false, Seconds(1.0));
    ASSERT_TRUE(axis == Axis::Azimuth ? bench->goTo(150.0, 45.0) : bench->goTo(60.0, 80.0));
    run(false, Seconds(6.0));
    const Angle pressedAt = of(axis, bench->truth());
    run(true, Seconds(6.0));
    const Angle stopped = of(axis, bench->truth());
    EXPECT_EQ(bench->control().state(), StationState::Fault);
    EXPECT_LT(stopped, pressedAt + 8_deg);
    run(true, Seconds(4.0));
    EXPECT_NEAR(of(axis, bench->truth()).degrees(), stopped.degrees(), 0.1);
    ASSERT_TRUE(bench->ask(request::Rearm{}));
    run(true, Seconds(2.0));
    EXPECT_FALSE(jog(3.0));
    ASSERT_TRUE(jog(-3.0));
    run(true, Seconds(5.0));
    EXPECT_LT(of(axis, bench->truth()), stopped - 3_deg);
}

std::unique_ptr<Bench> gs232Bench(gs232::Dialect dialect, bool azimuth = true, bool elevation = true)
{
    const gs232::Gs232Box::Habits habits{.dialect = dialect,
                                         .acknowledge = dialect == gs232::Dialect::A
                                                            ? gs232::Gs232Box::Acknowledge::Cr
                                                            : gs232::Gs232Box::Acknowledge::Prompt,
                                         .elevation = elevation};
    return std::make_unique<gs232::Gs232Bench>(habits, axesIf(azimuth, elevation));
}

std::unique_ptr<Bench> esp32Bench(bool azimuth, bool elevation)
{
    return std::make_unique<gs232::Esp32Bench>(axesIf(azimuth, elevation));
}

std::unique_ptr<Bench> rotctldBench(bool azimuth, bool elevation)
{
    return std::make_unique<rotctl::RotctldBench>(axesIf(azimuth, elevation));
}

INSTANTIATE_TEST_SUITE_P(
    Drivers, MountPromises,
    testing::Values(
        Kind{"TwoMoteus", [] { return std::make_unique<MoteusBench>(); }},
        Kind{"MoteusAzimuthOnly", [] { return moteusBench(AxisDriver::Moteus, AxisDriver::None); }},
        Kind{"MoteusElevationOnly", [] { return moteusBench(AxisDriver::None, AxisDriver::Moteus); }},
        Kind{"MoteusAndSimple", [] { return std::make_unique<MixedBench>(Axis::Azimuth); }},
        Kind{"SimpleAndMoteus", [] { return std::make_unique<MixedBench>(Axis::Elevation); }},
        Kind{"Simple", [] { return simpleBench(true, true); }},
        Kind{"SimpleAzimuthOnly", [] { return simpleBench(true, false); }},
        Kind{"SimpleElevationOnly", [] { return simpleBench(false, true); }},
        Kind{"Gs232A", [] { return gs232Bench(gs232::Dialect::A); }},
        Kind{"Gs232RareStarts", [] { return std::make_unique<gs232::Gs232Bench>(gs232::switchedProfile()); }},
        Kind{"Gs232B", [] { return gs232Bench(gs232::Dialect::B); }},
        Kind{"Gs232AzimuthOnly", [] { return gs232Bench(gs232::Dialect::B, true, false); }},
        Kind{"Gs232ElevationOnly", [] { return gs232Bench(gs232::Dialect::A, false, true); }},
        Kind{"Esp32", [] { return esp32Bench(true, true); }},
        Kind{"Esp32AzimuthOnly", [] { return esp32Bench(true, false); }},
        Kind{"Esp32ElevationOnly", [] { return esp32Bench(false, true); }},
        Kind{"Rotctld", [] { return rotctldBench(true, true); }},
        Kind{"RotctldAzimuthOnly", [] { return rotctldBench(true, false); }},
        Kind{"RotctldElevationOnly", [] { return rotctldBench(false, true); }},
        Kind{"RotctldStepped", [] { return std::make_unique<rotctl::RotctldBench>(rotctl::steppedProfile()); }},
        Kind{"Pair", [] { return std::make_unique<PairBench>(); }}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/offset_run.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

constexpr SteadyTime kOffsetStart{std::chrono::hours(1)};

SteadyTime offsetTime(double seconds)
{
    return kOffsetStart + std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds));
}

orientation::Orientation headingOf(double degrees)
{
    orientation::Orientation value;
    value.heading = orientation::SensorHeading::folded(Angle::fromDegrees(degrees));
    value.calibration = orientation::Calibration{.system = 3, .gyro = 3, .accelerometer = 3, .magnetometer = 3};
    return value;
}

AxesThen standingAt(double azimuthDegrees)
{
    return {.place = {.azimuth = Angle::fromDegrees(azimuthDegrees), .elevation = 0_deg}, .rates = {}};
}

OffsetRun withReadings(int count, const AxesThen& axes, double headingDegrees)
{
    OffsetRun run(kOffsetStart);
    for (int i = 0; i < count; ++i) {
        run.take(headingOf(headingDegrees), axes, {}, 5_deg);
    }
    return run;
}

TEST(OffsetRun, ItTakesTwentySeconds)
{
    const OffsetRun run(kOffsetStart);
    EXPECT_FALSE(run.done(offsetTime(19.9)));
    EXPECT_DOUBLE_EQ(0.5, run.part(offsetTime(10.0)));
    EXPECT_EQ(Seconds(10.0), run.left(offsetTime(10.0)));
    EXPECT_TRUE(run.done(offsetTime(20.0)));
    EXPECT_DOUBLE_EQ(1.0, run.part(offsetTime(30.0)));
    EXPECT_EQ(Seconds(0.0), run.left(offsetTime(30.0)));
}

TEST(OffsetRun, TheDeclinationIsPartOfNorth)
{
    const double addedBySensor = profile::SensorSettings{}.declinationInSensor.degrees();
    const OffsetRun run = withReadings(20, standingAt(100.0), 132.4 + addedBySensor);
    const auto offset = run.outcome({}, 5_deg);
    ASSERT_TRUE(offset) << textOf(offset.error());
    EXPECT_NEAR(37.4, offset->offset.value.degrees(), 1e-6);
    EXPECT_EQ(20U, offset->used);
    EXPECT_EQ(QStringLiteral("readings: 20"), run.text());
}

TEST(OffsetRun, WithoutReadingsThereIsNoNorth)
{
    EXPECT_FALSE(OffsetRun(kOffsetStart).outcome({}, 5_deg));
}

TEST(OffsetRun, AMotorThatDrawsCurrentSpoilsTheReadings)
{
    AxesThen driven = standingAt(100.0);
    driven.current = 3.0;
    EXPECT_FALSE(withReadings(20, driven, 132.4).outcome({}, 5_deg));
    profile::SensorSettings tolerant;
    tolerant.stillCurrent = 5.0;
    EXPECT_TRUE(withReadings(20, driven, 132.4).outcome(tolerant, 5_deg)) << "as sensor.still_current_a says";
}

}  // namespace
}  // namespace boresight

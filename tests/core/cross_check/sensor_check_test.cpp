// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace boresight {
namespace {

using Degrees = std::function<double(double second)>;

const SensorCheckSettings kSettings{
    .threshold = 10_deg, .time = Seconds(1.5), .latency = Seconds(0.6), .averaging = Seconds(1.0)};

SteadyTime sensorTime(double second)
{
    return SteadyTime{std::chrono::duration_cast<SteadyTime::duration>(Seconds(second))};
}

// Axes that report their position every 20 ms, and a sensor that reports every 1.03 s. Its value is the mean of the
// second that ended 0.1 s ago, plus an error.
struct CheckRig
{
    CheckRig(Degrees azimuthThen, Degrees elevationThen)
        : azimuth(std::move(azimuthThen)), elevation(std::move(elevationThen))
    {}

    [[nodiscard]] SensorDirection reading() const
    {
        double sum = 0.0;
        for (int i = 0; i < 11; ++i) {
            sum += azimuth(second - 1.1 + 0.1 * i);
        }
        return {.direction = {.azimuth = Angle::fromDegrees(sum / 11.0 + error).wrapped360(),
                              .elevation = Angle::fromDegrees(elevation(second - 0.1) + elevationError)},
                .arrival = sensorTime(second)};
    }

    void run(double seconds)
    {
        for (const double end = second + seconds; second < end; second += 0.02) {
            check.note(sensorTime(second), SkyPointing{.azimuth = Angle::fromDegrees(azimuth(second)).wrapped360(),
                                                       .elevation = Angle::fromDegrees(elevation(second))});
            if (second >= due) {
                due += 1.03;
                check.take(reading());
            }
            check.tick(sensorTime(second));
            everDisagreed = everDisagreed || check.disagrees();
            if (check.disagrees() && !told) {
                told = second;
            }
        }
    }

    Degrees azimuth;
    Degrees elevation;
    SensorCheck check{kSettings};
    double second = 0.0;
    double due = 0.5;
    double error = 0.0;
    double elevationError = 0.0;
    bool everDisagreed = false;
    std::optional<double> told;
};

Degrees constant(double value)
{
    return [value](double) { return value; };
}

// Back and forth at 12°/s, through north.
double slewing(double second)
{
    const double phase = std::fmod(second, 60.0);
    return 300.0 + 12.0 * (phase < 30.0 ? phase : 60.0 - phase);
}

// REQ-WITNESS-40 (SensorCheck.*): The orientation sensor is compared with the axes, with its latency and their motion
// taken into account. A lasting difference is amber within 3 s and disappears with its cause. Loss of the sensor is
// amber. Neither of them moves anything. When Boresight asks for a wrap, a calibrated sensor is shown as evidence.
// Before north was found, or while the sensor has never agreed, a difference in azimuth is not a warning but an
// advisory that names the panel North.
TEST(SensorCheck, MotionIsNoDisagreement)
{
    CheckRig rig(slewing, [](double second) { return 30.0 + 20.0 * std::sin(second / 2.0); });
    rig.run(180.0);
    EXPECT_FALSE(rig.everDisagreed);
    ASSERT_TRUE(rig.check.difference(Axis::Azimuth).now);
    EXPECT_LT(abs(*rig.check.difference(Axis::Azimuth).now), 3_deg);
}

// For an antenna without an elevation axis only the sensor knows the elevation of the beam.
TEST(SensorCheck, OfAMountWithOneAxisThatOneIsCompared)
{
    CheckRig low(constant(100.0), constant(0.0));
    low.check.leaveOut(Axis::Elevation);
    low.elevationError = 60.0;
    low.run(30.0);
    EXPECT_FALSE(low.everDisagreed);
    EXPECT_FALSE(low.check.difference(Axis::Elevation).now);
    low.error = 25.0;
    low.run(10.0);
    EXPECT_TRUE(low.check.difference(Axis::Azimuth).lasts) << "12.5° across the sky";
    CheckRig high(constant(100.0), constant(0.0));
    high.check.leaveOut(Axis::Elevation);
    high.elevationError = 80.0;
    high.run(30.0);
    EXPECT_FALSE(high.check.difference(Axis::Azimuth).now) << "its compass says nothing so near to the zenith";
    CheckRig upright(constant(0.0), constant(30.0));
    upright.check.leaveOut(Axis::Azimuth);
    upright.error = 120.0;
    upright.run(30.0);
    EXPECT_FALSE(upright.everDisagreed);
    EXPECT_FALSE(upright.check.difference(Axis::Azimuth).now);
    EXPECT_TRUE(upright.check.difference(Axis::Elevation).now);
}

TEST(SensorCheck, AnErrorWithinTheThresholdIsShownOnly)
{
    CheckRig rig(slewing, constant(30.0));
    rig.error = 9.0;
    rig.run(60.0);
    EXPECT_FALSE(rig.everDisagreed);
    EXPECT_NEAR(rig.check.difference(Axis::Azimuth).now->degrees(), 9.0, 3.0);
}

// At every phase of the sensor's second.
TEST(SensorCheck, ALargeErrorIsToldWithinThreeSecondsAndGoesWithItsCause)
{
    for (double phase = 0.0; phase < 1.05; phase += 0.05) {
        CheckRig rig(constant(350.0), constant(20.0));
        rig.run(10.0 + phase);
        const double begun = rig.second;
        rig.error = 25.0;
        rig.run(4.0);
        ASSERT_TRUE(rig.told) << phase;
        EXPECT_LE(*rig.told - begun, 3.0) << phase;
        EXPECT_NEAR(rig.check.difference(Axis::Azimuth).now->degrees(), 25.0, 0.1);
        rig.error = 8.0;
        rig.run(3.0);
        EXPECT_TRUE(rig.check.disagrees()) << "not clearly below the threshold";
        rig.error = 2.0;
        rig.run(3.0);
        EXPECT_FALSE(rig.check.disagrees());
    }
}

TEST(SensorCheck, OneOutlierIsNone)
{
    CheckRig rig(constant(100.0), constant(20.0));
    rig.run(10.0);
    const double begun = rig.due;
    rig.error = 90.0;
    rig.run(begun + 0.5 - rig.second);
    rig.error = 0.0;
    rig.run(10.0);
    EXPECT_FALSE(rig.everDisagreed);

    rig.error = 90.0;
    rig.run(rig.due + 0.1 - rig.second);
    rig.due += 60.0;  // after that it is silent
    rig.run(30.0);
    EXPECT_FALSE(rig.everDisagreed);
}

TEST(SensorCheck, TheElevationIsComparedToo)
{
    CheckRig rig(constant(100.0), constant(20.0));
    rig.run(5.0);
    rig.elevationError = -12.0;
    rig.run(4.0);
    EXPECT_TRUE(rig.check.difference(Axis::Elevation).lasts);
    EXPECT_FALSE(rig.check.difference(Axis::Azimuth).lasts);
    EXPECT_NEAR(rig.check.difference(Axis::Elevation).now->degrees(), -12.0, 1e-9);
}

TEST(SensorCheck, NearTheZenithAnAzimuthSaysNothing)
{
    CheckRig high(constant(100.0), constant(80.0));
    high.error = 90.0;
    high.run(10.0);
    EXPECT_FALSE(high.everDisagreed);
    EXPECT_FALSE(high.check.difference(Axis::Azimuth).now);
    CheckRig steep(constant(100.0), constant(60.0));
    steep.error = 18.0;
    steep.run(10.0);
    EXPECT_FALSE(steep.everDisagreed) << "across the sky these are 9°";
    steep.error = 22.0;
    steep.run(10.0);
    EXPECT_TRUE(steep.everDisagreed);
}

TEST(SensorCheck, WhereTheAxesAreNotKnownNothingIsCompared)
{
    CheckRig rig(constant(100.0), constant(20.0));
    rig.error = 90.0;
    rig.run(5.0);
    ASSERT_TRUE(rig.check.disagrees());
    rig.check.note(sensorTime(rig.second), std::nullopt);
    rig.check.take(rig.reading());
    EXPECT_FALSE(rig.check.disagrees());
    EXPECT_FALSE(rig.check.difference(Axis::Azimuth).now);
}

TEST(SensorCheck, SaysWhetherItBeganInMotion)
{
    CheckRig still(constant(100.0), constant(20.0));
    still.run(5.0);
    still.error = 40.0;
    still.run(5.0);
    EXPECT_FALSE(still.check.difference(Axis::Azimuth).beganMoving);
    CheckRig moving(slewing, constant(20.0));
    moving.run(5.0);
    moving.error = 40.0;
    moving.run(5.0);
    EXPECT_TRUE(moving.check.difference(Axis::Azimuth).beganMoving);
}

}  // namespace
}  // namespace boresight

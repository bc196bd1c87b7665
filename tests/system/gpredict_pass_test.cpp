// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/gpredict_client.h"
#include "tests/system/path_watch.h"
#include "tests/system/satellite_pass.h"
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The main task: Gpredict moves the mount through a pass of ten minutes that crosses north at 80°, clockwise and
// counterclockwise. The clock is turned by hand.
namespace boresight::system_test {
namespace {

struct PassCase
{
    const char* name;
    SatellitePass::Sense sense;
    Angle culmination;
    Angle standsAt;  // where the mount stands before Gpredict connects: this decides which wrap is the nearest
};

const PassCase kClockwise{"Clockwise", SatellitePass::Sense::Clockwise, 350_deg, 200_deg};
const PassCase kCounterClockwise{"CounterClockwise", SatellitePass::Sense::CounterClockwise, 10_deg, 160_deg};
constexpr Seconds kPrelude{60.0};  // before the satellite rises

SatellitePass passOf(const PassCase& passCase)
{
    return SatellitePass({.maxElevation = 80_deg, .culmination = passCase.culmination, .sense = passCase.sense});
}

// Station and Gpredict, which engages a minute before the satellite rises.
struct Tracking
{
    explicit Tracking(const PassCase& passCase)
        : pass(passOf(passCase)),
          rig(anyPort(), sim::commissionedPair({.azimuth = passCase.standsAt, .elevation = 10_deg})),
          gpredict(rig.connect(), pass),
          time(-pass.halfDuration() - kPrelude)
    {}

    void tick()
    {
        time += SimulatedStation::kTick;
        rig.tick();
        if (engaged) {
            gpredict.tick(time);
        }
        const StationStatus status = rig.status();
        if (status.azimuth.commanded) {
            const AxisPosition truth = rig.truth();
            azimuth.look(*status.azimuth.commanded, truth.azimuth, SimulatedStation::kTick);
            elevation.look(*status.elevation.commanded, truth.elevation, SimulatedStation::kTick);
        }
    }
    void runTo(Seconds end)
    {
        while (time < end) {
            tick();
        }
    }
    // The time from `S` until the antenna stays in place, within its backlash.
    Seconds disengage()
    {
        gpredict.disengage();
        engaged = false;
        const Seconds asked = time;
        std::vector<AxisPosition> path;
        while (time < asked + Seconds(3.0)) {
            tick();
            path.push_back(rig.truth());
        }
        const auto moving = std::find_if(path.rbegin(), path.rend(),
                                         [&](const AxisPosition& place) { return rig.farthestFrom(place) > 0.02_deg; });
        return SimulatedStation::kTick * static_cast<double>(path.rend() - moving);
    }

    SatellitePass pass;
    SimulatedStation rig;
    GpredictClient gpredict;
    Seconds time;
    bool engaged = true;
    AxisWatch azimuth;
    AxisWatch elevation;
};

std::string inDegrees(double value)
{
    return QString::number(value, 'f', 4).toStdString();
}

// Angle between the beam and the satellite, while the satellite is above 5°.
struct PointingError
{
    void look(const AxisPosition& beam, const SatellitePass::Look& satellite)
    {
        if (satellite.elevation > 5_deg) {
            const double error = separation({.azimuth = beam.azimuth, .elevation = beam.elevation},
                                            {.azimuth = satellite.azimuth, .elevation = satellite.elevation})
                                     .degrees();
            worst = std::max(worst, error);
            squares += error * error;
            ++count;
        }
    }
    [[nodiscard]] double rms() const { return std::sqrt(squares / count); }

    double worst = 0.0;
    double squares = 0.0;
    int count = 0;
};

class GpredictPass : public ::testing::TestWithParam<PassCase>
{
protected:
    void expectFollowing(const AxisWatch& axis, const tracking::MotionLimits& limits, const TravelRange& travel,
                         const std::string& name)
    {
        constexpr double kRounding = 1e-6;  // rounding of double differences
        EXPECT_LE(axis.fastest(), limits.speed.degrees() * (1.0 + kRounding)) << name;
        EXPECT_LE(axis.hardest(), limits.acceleration.degrees() * (1.0 + kRounding)) << name;
        EXPECT_GE(axis.lowest(), travel.min.degrees() - 0.2) << name;
        EXPECT_LE(axis.highest(), travel.max.degrees() + 0.2) << name;
        EXPECT_LE(axis.rms(), 0.05) << name;
        EXPECT_LE(axis.worst(), 0.2) << name;
        RecordProperty(name + "_fastest_deg_s", inDegrees(axis.fastest()));
        RecordProperty(name + "_hardest_deg_s2", inDegrees(axis.hardest()));
        RecordProperty(name + "_following_rms_deg", inDegrees(axis.rms()));
        RecordProperty(name + "_following_worst_deg", inDegrees(axis.worst()));
    }
};

// REQ-TRACKING-14b (GpredictPass.*)
TEST_P(GpredictPass, IsFollowedThroughNorthWithoutUnwinding)
{
    Tracking run(GetParam());
    const SatellitePass& pass = run.pass;
    EXPECT_NEAR(2.0 * pass.halfDuration().count(), 600.0, 15.0);
    run.runTo(-pass.halfDuration());
    const Angle rise = pass.at(-pass.halfDuration()).azimuth;
    EXPECT_NEAR(run.rig.truth(Axis::Azimuth), rise.degrees(), 0.2) << "it waits where the satellite will rise";

    const double sign = GetParam().sense == SatellitePass::Sense::Clockwise ? 1.0 : -1.0;
    const double before = run.azimuth.turned();
    PointingError error;
    double farthest = run.rig.truth(Axis::Azimuth) * sign;
    double setBack = 0.0;
    while (run.time < pass.halfDuration()) {
        run.tick();
        error.look(run.rig.truth(), pass.at(run.time));
        const double azimuth = run.rig.truth(Axis::Azimuth) * sign;
        farthest = std::max(farthest, azimuth);
        setBack = std::max(setBack, farthest - azimuth);
    }
    const Angle sweep = abs(pass.at(pass.halfDuration()).azimuth - rise);
    EXPECT_GT(sweep, 160_deg);
    EXPECT_NEAR(run.rig.truth(Axis::Azimuth), (rise + sign * sweep).degrees(), 0.5) << "it did not go the other way";
    EXPECT_LT(setBack, 0.05) << "it never turned back";
    EXPECT_NEAR(run.azimuth.turned() - before, sweep.degrees(), 2.0);

    const profile::Profile profile;
    expectFollowing(run.azimuth, profile.azimuth.limits, profile.azimuth.geometry.travel, "azimuth");
    expectFollowing(run.elevation, profile.elevation.limits, profile.elevation.geometry.travel, "elevation");
    EXPECT_LE(error.rms(), 0.35);
    EXPECT_LE(error.worst, 1.6);
    EXPECT_THAT(run.gpredict.complaints(), ::testing::IsEmpty());
    EXPECT_GT(run.gpredict.exchanges(), 1000);
    EXPECT_LE(run.disengage(), Seconds(0.3));
    RecordProperty("pointing_rms_deg", inDegrees(error.rms()));
    RecordProperty("pointing_worst_deg", inDegrees(error.worst));
    RecordProperty("set_back_deg", inDegrees(setBack));
    RecordProperty("exchanges", run.gpredict.exchanges());
    RecordProperty("longest_reply_bytes", static_cast<int>(run.gpredict.longestReply()));
}

INSTANTIATE_TEST_SUITE_P(AtEightyDegrees, GpredictPass, ::testing::Values(kClockwise, kCounterClockwise),
                         [](const auto& passCase) { return std::string(passCase.param.name); });

// At 1°/s the mount stands 0.3 s after the command. Where the azimuth turns fast near the zenith it needs its ramp:
// speed / acceleration, twice acceleration / jerk for the rounding, and one tick until the command takes effect.
TEST(GpredictDisengage, StopsAsFastAsTheLimitsAllow)
{
    Tracking run(kClockwise);
    run.runTo(Seconds(-60.0));
    Tracking race(kClockwise);
    race.runTo(Seconds(0.0));
    const double speed = race.rig.status().azimuth.commandedRate->degrees();
    EXPECT_GT(speed, 5.0);
    const Seconds slow = run.disengage();
    const Seconds fast = race.disengage();
    EXPECT_LE(slow, Seconds(0.3));
    EXPECT_LE(fast, Seconds(speed / 10.0 + 0.2 + 0.1));
    RecordProperty("from_one_deg_s_in_s", inDegrees(slow.count()));
    RecordProperty("at_culmination_deg_s", inDegrees(speed));
    RecordProperty("at_culmination_in_s", inDegrees(fast.count()));
}

}  // namespace
}  // namespace boresight::system_test

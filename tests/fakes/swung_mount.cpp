// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/swung_mount.h"

#include "tests/fakes/chance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::fakes {
namespace {

using namespace boresight::calibration;

constexpr double kAssumedLatency = 0.5;  // s
constexpr double kGravity = 9.81;        // m/s²
constexpr double kGravityStep = 0.01;    // m/s², resolution of the sensor
constexpr double kGravityNoise = 0.02;   // m/s² rms
constexpr double kSteelWidth = 30.0;

double radians(double degrees)
{
    return Angle::fromDegrees(degrees).radians();
}

double degrees(double radians)
{
    return Angle::fromRadians(radians).degrees();
}

double rounded(double value, double step)
{
    return std::round(value / step) * step;
}

// The azimuth that the compass shows with the iron: the field along the box and across it, deflected.
double bent(const SwungMount& mount, double heading)
{
    const double forward = std::cos(radians(heading));
    const double right = -std::sin(radians(heading));
    const auto& soft = mount.softIron;
    const double seenForward = (1.0 + soft[0][0]) * forward + soft[0][1] * right + mount.hardForward;
    const double seenRight = soft[1][0] * forward + (1.0 + soft[1][1]) * right + mount.hardRight;
    return degrees(std::atan2(-seenRight, seenForward)) + mount.askew;
}

double withHarmonics(const SwungMount& mount, double heading)
{
    return heading + mount.firstAmplitude * std::sin(radians(heading - mount.firstPhase)) +
           mount.secondAmplitude * std::sin(2.0 * radians(heading - mount.secondPhase));
}

struct Vector
{
    double north, east, up;
};

Vector direction(const SkyPointing& sky)
{
    const double azimuth = sky.azimuth.radians();
    const double elevation = sky.elevation.radians();
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

// The angle between the vertical and the z axis of the box, which is upright while the boom is level.
double levelReading(const SwungMount& mount, double azimuth, double elevation, std::mt19937_64& random)
{
    const pointing::PointingModel model(mount.terms);
    const Vector upright = direction(model.toSky({Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation + 90.0)}));
    const Vector side = direction(model.toSky({Angle::fromDegrees(azimuth + 90.0), Angle{}}));
    const double up = std::cos(radians(mount.roll)) * upright.up + std::sin(radians(mount.roll)) * side.up;
    const double gravity = rounded(kGravity * up + mount.gravityBias + gaussian(random, kGravityNoise), kGravityStep);
    return rounded(90.0 - degrees(std::asin(std::clamp(gravity / kGravity, -1.0, 1.0))), 0.01);
}

class Sensor
{
public:
    Sensor(const SwungMount& mount, std::mt19937_64& random) : m_mount(mount), m_random(random) {}

    void sweep(const SwingPlan& plan, Turning turning, Swung& swung)
    {
        const bool clockwise = turning == Turning::Clockwise;
        const double start = clockwise ? plan.from : plan.to;
        const double rate = clockwise ? plan.rate : -plan.rate;
        const double duration = (plan.to - plan.from) / plan.rate;
        for (double time = 1.0; time < duration; time += plan.period) {
            const double about = start + rate * (time - m_mount.latency);
            const double assumed = start + rate * (time - kAssumedLatency);
            const double now = start + rate * time;
            swung.samples.push_back(
                {.axisAzimuth = Angle::fromDegrees(assumed),
                 .axisRate = AngularRate::fromDegrees(rate),
                 .turning = turning,
                 .heading = orientation::SensorHeading::folded(Angle::fromDegrees(read(about, plan.elevation))),
                 .magnetometerCalibration = 3,
                 .motorCurrent = 0.5,
                 .axisElevation = Angle::fromDegrees(plan.elevation)});
            swung.levels.push_back(
                {.axisAzimuth = Angle::fromDegrees(now),
                 .axisElevation = Angle::fromDegrees(plan.elevation),
                 .elevation = Angle::fromDegrees(levelReading(m_mount, now, plan.elevation, m_random))});
        }
    }

private:
    double read(double azimuth, double elevation)
    {
        const double fresh = std::sqrt(1.0 - m_mount.memory * m_mount.memory);
        m_noise = m_mount.memory * m_noise + fresh * gaussian(m_random, m_mount.noise);
        if (uniform(m_random, 0.0, 1.0) < m_mount.outliers) {
            return rounded(uniform(m_random, 0.0, 360.0), 0.01);
        }
        return rounded(m_mount.heading(azimuth, elevation) + m_noise, 0.01);
    }

    const SwungMount& m_mount;
    std::mt19937_64& m_random;
    double m_noise = 0.0;
};

void bendWithIron(SwungMount& mount, std::mt19937_64& random)
{
    const double strength = std::sin(radians(uniform(random, 0.0, 8.0)));
    const double phase = uniform(random, 0.0, 360.0);
    mount.hardForward = strength * std::cos(radians(phase));
    mount.hardRight = strength * std::sin(radians(phase));
    for (auto& row : mount.softIron) {
        for (double& element : row) {
            element = gaussian(random, 0.03);
        }
    }
    mount.askew = gaussian(random, 0.5);
}

}  // namespace

double SwungMount::heading(double axisAzimuth, double axisElevation) const
{
    const pointing::PointingModel model(terms);
    const double truth =
        model.toSky({Angle::fromDegrees(axisAzimuth), Angle::fromDegrees(axisElevation)}).azimuth.degrees();
    const double clockwise = needle == Needle::Iron ? bent(*this, truth) : withHarmonics(*this, truth);
    const double intoSteel = Angle::fromDegrees(axisAzimuth - steelFrom).wrapped360().degrees();
    const double said = clockwise + (intoSteel < kSteelWidth ? steelStep : 0.0);
    return sense == AzimuthSense::Clockwise ? said : -said;
}

SwungMount randomMount(std::mt19937_64& random, Needle needle)
{
    SwungMount mount;
    mount.needle = needle;
    const double tilt = uniform(random, 0.0, 1.0);
    const double tiltTo = uniform(random, 0.0, 360.0);
    mount.terms = {.azimuthOffset = Angle::fromDegrees(uniform(random, 0.0, 360.0)),
                   .elevationOffset = {},
                   .tiltNorth = Angle::fromDegrees(tilt * std::cos(radians(tiltTo))),
                   .tiltEast = Angle::fromDegrees(tilt * std::sin(radians(tiltTo))),
                   .collimation = {},
                   .nonPerpendicularity = {},
                   .elevationSag = {}};
    mount.sense = uniform(random, 0.0, 1.0) < 0.5 ? AzimuthSense::Clockwise : AzimuthSense::CounterClockwise;
    mount.firstAmplitude = uniform(random, 0.0, 8.0);
    mount.firstPhase = uniform(random, 0.0, 360.0);
    mount.secondAmplitude = uniform(random, 0.0, 3.0);
    mount.secondPhase = uniform(random, 0.0, 360.0);
    mount.latency = 0.5 + gaussian(random, 0.1);
    mount.roll = gaussian(random, 2.0);
    mount.gravityBias = gaussian(random, 0.05);
    if (uniform(random, 0.0, 1.0) < 0.2) {
        mount.steelFrom = uniform(random, 0.0, 360.0);
        mount.steelStep = 15.0;
    }
    if (needle == Needle::Iron) {
        bendWithIron(mount, random);
    }
    return mount;
}

Swung swing(const SwungMount& mount, std::mt19937_64& random, const SwingPlan& plan)
{
    Swung swung;
    Sensor sensor(mount, random);
    sensor.sweep(plan, Turning::Clockwise, swung);
    if (plan.back) {
        sensor.sweep(plan, Turning::CounterClockwise, swung);
    }
    return swung;
}

}  // namespace boresight::fakes

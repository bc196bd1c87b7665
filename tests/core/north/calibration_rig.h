// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_desk.h"
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

// A calibration desk beside StationControl with two ideal drives. The mount does not know the truth: where north is,
// how the mast leans, where the beam looks, and how iron deflects the compass of a sensor that reports once a second,
// half a second late. The clock is turned by hand.
namespace boresight {

struct HiddenTruth
{
    pointing::PointingTerms terms{.azimuthOffset = Angle::fromDegrees(37.4),
                                  .elevationOffset = {},
                                  .tiltNorth = Angle::fromDegrees(0.6 * 0.8),
                                  .tiltEast = Angle::fromDegrees(-0.6 * 0.6),
                                  .collimation = Angle::fromDegrees(0.3),
                                  .nonPerpendicularity = {},
                                  .elevationSag = {}};
    double firstAmplitude = 8.0;  // degrees, of the deviation
    double firstPhase = 50.0;
    double secondAmplitude = 3.0;
    double secondPhase = 20.0;
    double noise = 0.5;
    double latency = 0.5;      // s
    double declination = 5.0;  // east
};

inline double sine(double degrees)
{
    return std::sin(degrees * std::numbers::pi / 180.0);
}

// A mast in Vienna.
inline profile::Profile calibratedProfile()
{
    profile::Profile profile;
    profile.site = {.known = true, .latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0};
    profile.sensor.source = profile::SensorSource::Simulated;
    profile.sensor.latency = Seconds(0.5);
    profile.sensor.averaging = Seconds(0.2);
    profile.control.tickHz = 20;  // runs last for minutes
    profile.control.watchdog = Seconds(0.2);
    return profile;
}

// The full tick rate. At 20 Hz a drive counts as silent before enough replies are lost to hide its position.
inline profile::Profile calibratedAtFullRate()
{
    profile::Profile profile = calibratedProfile();
    profile.control = profile::Profile{}.control;
    return profile;
}

class CalibrationRig : public StationRig
{
public:
    explicit CalibrationRig(const HiddenTruth& hidden = {}, const profile::Profile& settings = calibratedProfile(),
                            const QString& stateDir = {})
        : StationRig(settings),
          truth(hidden),
          model(hidden.terms),
          file(std::make_unique<CalibrationFile>(
              stateDir.isEmpty() ? QString() : calibrationPath(stateDir, toQString(settings.mount.name), false))),
          desk(control, inForce, *file, clock, log)
    {
        run(Seconds(1.0));
        ask(request::TakeAuthority{});
    }

    Result<> ask(const Request& request)
    {
        return control.request(request, kOperator).and_then([&]() -> Result<> {
            const auto* const wanted = std::get_if<CalibrationRequest>(&request);
            const Result<> done = wanted ? desk.carryOut(*wanted) : Result<>{};
            putIntoForce();
            tick();
            return done;
        });
    }

    void tick()
    {
        desk.tick();
        StationRig::tick();
        speak();
    }
    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / step); ++i) {
            tick();
        }
    }
    // Runs until no calibration is running, for at most `longest`.
    void runOut(Seconds longest = Seconds(600.0))
    {
        tick();
        for (Seconds left = longest; left > Seconds(0.0) && desk.status()->progress.run != CalibrationRun::None;
             left -= step) {
            tick();
        }
    }
    void goTo(double azimuthDegrees, double elevationDegrees)
    {
        ASSERT_TRUE(ask(request::PointAxes{
            {.azimuth = Angle::fromDegrees(azimuthDegrees), .elevation = Angle::fromDegrees(elevationDegrees)}}));
        run(Seconds(40.0));
    }

    // Gives the profile to StationControl and the desk, as the station does.
    void setProfile(const profile::Profile& wanted)
    {
        const auto before = inForce.shared();
        StationRig::setProfile(wanted);
        desk.profileChanged(*before, *inForce);
    }

    // the present status: the next tick makes another
    [[nodiscard]] CalibrationStatus status() { return *desk.status(); }
    [[nodiscard]] AxisPosition axes() const { return *control.measured(); }
    [[nodiscard]] const pointing::PointingTerms& terms() const { return profile.pointing; }
    [[nodiscard]] Result<> apply()
    {
        return status().proposal ? ask(request::ApplyCalibration{status().proposal->number})
                                 : failure(ErrorCode::Refused, QStringLiteral("Nothing is proposed"));
    }

    // The direction of the beam of the hidden mount.
    [[nodiscard]] SkyPointing beam() const { return pointing::upright(model.toSky(axes())); }

    HiddenTruth truth;
    pointing::PointingModel model;
    std::unique_ptr<CalibrationFile> file;
    CalibrationDesk desk;
    std::mt19937_64 random{20261121};
    bool speaks = true;
    std::uint64_t restarts = 0;  // of the sensor
    std::optional<orientation::Calibration> calibration =
        orientation::Calibration{.system = 3, .gyro = 3, .accelerometer = 3, .magnetometer = 3};

private:
    void putIntoForce()
    {
        if (const auto change = desk.takeChange()) {
            profile::Profile wanted = profile;
            change->applyTo(wanted);
            setProfile(wanted);
        }
    }

    double gaussian(double sigma) { return std::normal_distribution<double>(0.0, sigma)(random); }

    // The reading that arrives was measured one latency earlier.
    void speak()
    {
        if (const auto here = control.measured()) {
            m_past.push_back({clock.now(), *here});
        }
        while (!m_past.empty() && Seconds(clock.now() - m_past.front().time) > Seconds(truth.latency)) {
            m_then = m_past.front().axes;
            m_past.pop_front();
        }
        if (!speaks || !m_then || clock.now() < m_next) {
            return;
        }
        m_next = clock.now() + std::chrono::milliseconds(1030);
        // The sensor box sits on the boom, so the collimation of the beam does not affect it.
        pointing::PointingTerms boom = truth.terms;
        boom.collimation = {};
        const SkyPointing direction = pointing::PointingModel(boom).toSky(*m_then);
        const double heading = direction.azimuth.degrees() - truth.declination;
        const double deviation = truth.firstAmplitude * sine(heading - truth.firstPhase) +
                                 truth.secondAmplitude * sine(2.0 * (heading - truth.secondPhase));
        const double said = heading + deviation + gaussian(truth.noise) + profile.sensor.declinationInSensor.degrees();
        orientation::Orientation value;
        value.heading = orientation::SensorHeading::folded(Angle::fromDegrees(said));
        value.elevation = direction.elevation + Angle::fromDegrees(gaussian(0.1));
        value.calibration = calibration;
        value.arrival = clock.now();
        SensorStatus sensor;
        sensor.last = value;
        sensor.restarts = restarts;
        sensor.declination = Angle::fromDegrees(truth.declination);
        desk.take(sensor);
    }

    struct Past
    {
        SteadyTime time;
        AxisPosition axes;
    };
    std::deque<Past> m_past;
    std::optional<AxisPosition> m_then;
    SteadyTime m_next{};
};

}  // namespace boresight

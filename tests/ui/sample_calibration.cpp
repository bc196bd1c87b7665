// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_calibration.h"

#include "tests/ui/sample_permissions.h"
#include "tests/ui/sample_status.h"

#include <cmath>
#include <random>

namespace boresight::samples {

namespace {

constexpr Angle kNorth = 37.4_deg;
constexpr Angle kPoint = 40_deg;  // between two points of the Sun

calibration::SwingSample swingSample(double axisDegrees, calibration::Turning turning, double noise)
{
    const double heading = (axisDegrees + kNorth.degrees()) * std::numbers::pi / 180.0;
    const double iron = 8.0 * std::sin(heading + 0.6) + 3.0 * std::sin(2.0 * heading - 0.4);
    const double lag = turning == calibration::Turning::Clockwise ? 0.4 : -0.4;
    return {.axisAzimuth = Angle::fromDegrees(axisDegrees),
            .axisRate = 3_deg_s,
            .turning = turning,
            .heading = orientation::SensorHeading::folded(
                Angle::fromDegrees(axisDegrees + kNorth.degrees() + iron + lag + noise)),
            .magnetometerCalibration = 3,
            .motorCurrent = 0.8};
}

// A steel fence in the north-west, and a lorry that passed.
std::vector<calibration::SwingSample> swingSamples()
{
    std::vector<calibration::SwingSample> samples;
    std::minstd_rand random(20260601);
    std::normal_distribution<double> noise(0.0, 0.6);
    for (const auto turning : {calibration::Turning::Clockwise, calibration::Turning::CounterClockwise}) {
        for (int axis = -80; axis < 280; axis += 5) {
            const double heading = std::fmod(axis + kNorth.degrees() + 360.0, 360.0);
            const double fence = heading > 290.0 && heading < 330.0 ? 6.0 : 0.0;
            const double lorry = axis == 100 && turning == calibration::Turning::Clockwise ? 14.0 : 0.0;
            samples.push_back(swingSample(axis, turning, noise(random) + fence + lorry));
        }
    }
    return samples;
}

std::shared_ptr<const SwingOutcome> swingOutcome(UtcTime when)
{
    SwingOutcome outcome{.when = when, .samples = swingSamples()};
    outcome.fit = calibration::fitCompassSwing(outcome.samples).value();
    outcome.tilt = calibration::AxisTilt{.north = {0.42_deg, 0.05_deg},
                                         .east = {-0.43_deg, 0.05_deg},
                                         .size = 0.6_deg,
                                         .sizeSigma = 0.05_deg,
                                         .direction = 314_deg,
                                         .elevationOffset = {-0.8_deg, 1.0_deg},
                                         .scatter = 0.31_deg,
                                         .residuals = {},
                                         .rejected = {}};
    return std::make_shared<const SwingOutcome>(outcome);
}

SwingPlan swingPlan()
{
    return {
        .azimuth = {-80_deg, 280_deg},
        .elevation = 30_deg,
        .rate = 3_deg_s,
        .headings = 0,
        .duration = Seconds(250.0),
        .text = QStringLiteral("turns from 0.0° to -80.0°, to 280.0° and back to -80.0° at elevation 30.0°, 3.0°/s; "
                               "takes 4 min"),
        .obstacle = {}};
}

// The Sun during a day in June, with its residual for a model without the offset.
PointStatus pointAt(int index, bool isUsed, UtcTime when)
{
    const double step = index - 2.5;
    const SkyPointing truth{.azimuth = 180_deg + step * kPoint,
                            .elevation = Angle::fromDegrees(62.0 - 4.5 * step * step)};
    const double wobble = std::sin(index * 2.1);
    const AxisPosition axes{.azimuth = truth.azimuth - kNorth, .elevation = truth.elevation};
    return {.label = index == 3 ? QStringLiteral("church tower") : QStringLiteral("Sun"),
            .when = when - std::chrono::minutes(90 * (6 - index)),
            .axes = axes,
            .truth = truth,
            .sigma = 0.05_deg,
            .isUsed = isUsed,
            .before = {.across = Angle::fromDegrees(0.55 + 0.2 * wobble),
                       .elevation = Angle::fromDegrees(0.4 * std::cos(index * 1.1))},
            .after = PointResidual{.across = Angle::fromDegrees(0.03 * wobble),
                                   .elevation = Angle::fromDegrees(0.02 * std::cos(index * 2.7))},
            .leftOut = Angle::fromDegrees(0.04 + 0.02 * std::abs(wobble))};
}

TermStatus term(const char* key, double present, double proposed, std::optional<double> sigma)
{
    return {.key = key,
            .present = Angle::fromDegrees(present),
            .proposed = Angle::fromDegrees(proposed),
            .sigma = sigma ? std::optional(Angle::fromDegrees(*sigma)) : std::nullopt,
            .isOn = sigma.has_value()};
}

std::vector<TermStatus> sixPointTerms()
{
    return {term("pointing.azimuth_offset_deg", 36.1, 37.412, 0.021),
            term("pointing.elevation_offset_deg", 0.0, -0.213, 0.018),
            term("pointing.tilt_north_deg", 0.0, 0.418, 0.030),
            term("pointing.tilt_east_deg", 0.0, -0.431, 0.034),
            term("pointing.collimation_deg", 0.0, 0.302, 0.041),
            term("pointing.non_perpendicularity_deg", 0.0, 0.0, std::nullopt),
            term("pointing.elevation_sag_deg", 0.0, 0.0, std::nullopt)};
}

std::vector<BodyNow> bodiesAt(UtcTime now)
{
    return {{.body = ephemeris::Body::Sun,
             .direction = {143.2_deg, 52.1_deg},
             .isUp = true,
             .obstacle = {},
             .obstacleOverTheTop = {},
             .nextRise = now + std::chrono::hours(11),
             .nextSet = now + std::chrono::minutes(214)},
            {.body = ephemeris::Body::Moon,
             .direction = {301.7_deg, -11.4_deg},
             .isUp = false,
             .obstacle = QStringLiteral("it is below the lowest elevation 5.0°"),
             .obstacleOverTheTop =
                 QStringLiteral("The travel and the limits of the axes do not permit this direction over the top."),
             .nextRise = now + std::chrono::minutes(338),
             .nextSet = std::nullopt}};
}

CalibrationStatus sample(const StationStatus& status)
{
    CalibrationStatus calibration;
    calibration.present.azimuthOffset = 36.1_deg;
    calibration.swingPlan = swingPlan();
    calibration.bodies = bodiesAt(status.utc);
    return calibration;
}

StationStatus with(StationStatus status, const CalibrationStatus& calibration)
{
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    return status;
}

}  // namespace

StationStatus beforeCalibration()
{
    StationStatus status = bounded();
    status.sensor.source = QStringLiteral("simulated");
    CalibrationStatus calibration = sample(status);
    calibration.present = {};
    calibration.sensorObstacle =
        QStringLiteral("the sensor's magnetometer is calibrated to 1 of 3, at least 2 is needed: figure of eight");
    calibration.pointObstacle = QStringLiteral("Track the Sun or the Moon first");
    return with(status, calibration);
}

StationStatus swinging()
{
    StationStatus status = bounded();
    status.state = StationState::Calibrate;
    status.stateReason = QStringLiteral("compass swing");
    status.permissions = inMotion();
    status.azimuth.state = AxisState::Moving;
    CalibrationStatus calibration = sample(status);
    calibration.progress = {.run = CalibrationRun::Swing,
                            .done = 0.43,
                            .left = Seconds(142.0),
                            .text = QStringLiteral("turning clockwise, 143 samples"),
                            .outcome = {},
                            .failed = false};
    const auto samples = swingSamples();
    calibration.swingSoFar = calibration::dotsOf(std::span(samples).first(samples.size() * 3 / 5), {},
                                                 calibration::AzimuthSense::Clockwise, 400);
    return with(status, calibration);
}

StationStatus swung()
{
    const StationStatus status = bounded();
    CalibrationStatus calibration = sample(status);
    calibration.present = {};
    calibration.swing = swingOutcome(status.utc);
    calibration.progress.outcome = QStringLiteral("the swing is done: see what it has found");
    const calibration::Estimate north = calibration.swing->fit.north;
    calibration.proposal = CalibrationProposal{
        .number = 7,
        .title = QStringLiteral("North from the compass swing"),
        .reason = QStringLiteral("compass swing"),
        .text = {},
        .terms = {term("pointing.azimuth_offset_deg", 0.0, north.value.degrees(), north.sigma.degrees()),
                  term("pointing.tilt_north_deg", 0.0, 0.42, 0.05), term("pointing.tilt_east_deg", 0.0, -0.43, 0.05)},
        .changesSensor = true,
        .warnings = {},
        .obstacle = {}};
    return with(status, calibration);
}

StationStatus heard()
{
    StationStatus status = swung();
    orientation::Orientation last;
    last.heading = orientation::SensorHeading::folded(63.1_deg);
    last.elevation = 45.3_deg;
    last.calibration = orientation::Calibration{.system = 2, .gyro = 3, .accelerometer = 1, .magnetometer = 3};
    status.sensor.source = QStringLiteral("serial /dev/ttyUSB0");
    status.sensor.open = true;
    status.sensor.presence = orientation::Presence::Present;
    status.sensor.last = last;
    status.sensor.age = std::chrono::milliseconds(300);
    status.sensor.direction = SkyPointing{.azimuth = 58.1_deg, .elevation = 45.2_deg};
    status.sensor.azimuthSigma = 1.7_deg;
    status.sensor.declination = -1.9_deg;
    status.sensor.declinationModel = QStringLiteral("WMM-2025, 2025.0 to 2030.0");
    status.sensor.declinationText =
        QStringLiteral("Boresight adds a declination of -1.9° (magnetic model) and removes the sensor's 5.1°.");
    status.sensor.azimuthDifference = 0.7_deg;
    status.sensor.elevationDifference = 0.2_deg;
    CalibrationStatus calibration = *status.calibration;
    calibration.sensorOffset = calibration::SensorOffset{
        .offset = {38.2_deg, 6.1_deg}, .statistical = 0.2_deg, .scatter = 0.6_deg, .used = 20, .rejected = 0};
    return with(status, calibration);
}

StationStatus swungInVain()
{
    StationStatus status = swung();
    CalibrationStatus calibration = *status.calibration;
    SwingOutcome outcome = *calibration.swing;
    outcome.fit.hopeless = {QStringLiteral(
        "the needle is off by more than 35° somewhere: this place is magnetically hopeless, take the Sun or the Moon")};
    outcome.tilt.reset();
    outcome.noTilt = QStringLiteral("the boom was below 10° and the sensor cannot tell up from down there");
    calibration.swing = std::make_shared<const SwingOutcome>(outcome);
    calibration.proposal->warnings = {QStringLiteral("this place is magnetically hopeless")};
    calibration.proposal->obstacle = QStringLiteral("a hopeless swing is not applied: take the Sun or the Moon");
    return with(status, calibration);
}

StationStatus followingSun()
{
    StationStatus status = bounded();
    status.state = StationState::Track;
    status.stateReason = QStringLiteral("following the Sun");
    status.permissions = inMotion();
    status.targetText = QStringLiteral("Sun");
    status.commander = {SourceKind::Station, 0, QStringLiteral("calibration")};
    status.trim = SkyPointing{.azimuth = 0.3_deg, .elevation = -0.1_deg};
    CalibrationStatus calibration = sample(status);
    calibration.body = ephemeris::Body::Sun;
    calibration.following = true;
    calibration.warning = QStringLiteral(
        "The antenna points at the Sun. Never look along the beam or a sight tube without a solar filter. Watch the "
        "heat at the feed");  // in the words of the station: it must fit
    for (int index = 0; index < 3; ++index) {
        calibration.points.push_back(pointAt(index, true, status.utc));
    }
    return with(status, calibration);
}

StationStatus followingOverTheTop()
{
    StationStatus status = followingSun();
    status.elevation.travel.max = 180_deg;
    CalibrationStatus calibration = *status.calibration;
    calibration.overTheTop = true;
    return with(status, calibration);
}

StationStatus scanning()
{
    StationStatus status = followingSun();
    status.state = StationState::Calibrate;
    CalibrationStatus calibration = *status.calibration;
    calibration.progress = {.run = CalibrationRun::CrossScan,
                            .done = 0.3,
                            .left = Seconds(90.0),
                            .text = QStringLiteral("across, place 5 of 9: give the power"),
                            .outcome = {},
                            .failed = false};
    calibration.wantsPower = true;
    calibration.powerLine = {.name = QStringLiteral("UDP 127.0.0.1:4540"), .decibels = -73.25, .age = Seconds(2.0)};
    return with(status, calibration);
}

// A Sun of 3 dB in a beam of 2°, 0.6° to the right and 0.4° below the middle.
StationStatus scanned()
{
    StationStatus status = followingSun();
    CalibrationStatus calibration = *status.calibration;
    std::minstd_rand random(20260621);
    std::normal_distribution<double> noise(0.0, 0.001);
    const auto line = [&](double peak) {
        std::vector<calibration::ScanReading> readings;
        for (int place = -4; place <= 4; ++place) {
            const double off = (0.5 * place - peak) / 2.0;
            readings.push_back({Angle::fromDegrees(0.5 * place),
                                -73.0 + 10.0 * std::log10(1.0 + std::exp2(-4.0 * off * off)) + noise(random)});
        }
        return readings;
    };
    const auto scan =
        calibration::fitCrossScan({.azimuth = 105_deg, .elevation = 31_deg}, line(0.6), line(-0.4), 0.6_deg);
    if (scan) {
        calibration.scan = *scan;
    }
    calibration.powerLine = {.name = QStringLiteral("UDP 127.0.0.1:4540"), .decibels = -70.02, .age = Seconds(0.4)};
    return with(status, calibration);
}

StationStatus sixPoints()
{
    const StationStatus status = bounded();
    CalibrationStatus calibration = sample(status);
    for (int index = 0; index < 6; ++index) {
        calibration.points.push_back(pointAt(index, index != 3, status.utc));
    }
    calibration.body = ephemeris::Body::Sun;
    calibration.pointObstacle = QStringLiteral("the Sun is not followed");
    calibration.fit = PointFitStatus{
        .terms = sixPointTerms(),
        .before = 0.912_deg,
        .after = 0.031_deg,
        .reducedChiSquare = 0.9,
        .remarks = {QStringLiteral("5 terms are on; the points do not ask for non-perpendicularity and sag"),
                    QStringLiteral("the church tower is not used")}};
    calibration.proposal = CalibrationProposal{.number = 12,
                                               .title = QStringLiteral("Pointing model from 5 points"),
                                               .reason = QStringLiteral("points"),
                                               .text = {},
                                               .terms = sixPointTerms(),
                                               .changesSensor = true,
                                               .warnings = {},
                                               .obstacle = {}};
    calibration.history = {{.when = status.utc - std::chrono::hours(26),
                            .title = QStringLiteral("North from the compass swing"),
                            .change = QStringLiteral("azimuth offset 0.00° → 36.10°, curve of the sensor"),
                            .place = QStringLiteral("Porto 41.15° -8.61°"),
                            .inForce = true,
                            .otherMount = false},
                           {.when = status.utc - std::chrono::hours(2400),
                            .title = QStringLiteral("Pointing model from 6 points"),
                            .change = QStringLiteral("azimuth offset 0.00° → 112.40°, collimation 0.00° → 0.31°"),
                            .place = QStringLiteral("Braga 41.55° -8.42°, other drives"),
                            .inForce = false,
                            .otherMount = true}};
    calibration.canUndo = true;
    return with(status, calibration);
}

}  // namespace boresight::samples

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sensor_option.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace boresight::ctl {
namespace {

using sim::SensorTruth;

Angle degrees(double number)
{
    return Angle::fromDegrees(number);
}

constexpr std::array<SensorOption, 9> kSensorOptionOptions{{
    {.name = "sensor-north",
     .values = "DEGREES",
     .text = "true azimuth of the beam minus the angle of the azimuth axis. Default 37.4",
     .min = -360.0,
     .max = 360.0,
     .set = [](SensorTruth& truth, const double* n) { truth.mount.azimuthOffset = degrees(n[0]); }},
    {.name = "sensor-tilt",
     .values = "NORTH,EAST",
     .text = "lean of the azimuth axis, in degrees. Default 0.4,-0.45",
     .min = -20.0,
     .max = 20.0,
     .set =
         [](SensorTruth& truth, const double* n) {
             truth.mount.tiltNorth = degrees(n[0]);
             truth.mount.tiltEast = degrees(n[1]);
         }},
    {.name = "sensor-mounting",
     .values = "AZ,EL",
     .text = "true direction of the beam when the sensor reports 0 and 0, in degrees. Default 0,0",
     .min = -360.0,
     .max = 360.0,
     .set =
         [](SensorTruth& truth, const double* n) {
             truth.mountingOffset = degrees(n[0]);
             truth.elevationOffset = degrees(n[1]);
         }},
    {.name = "sensor-declination",
     .values = "DEGREES",
     .text = "declination of the site, east positive. Default 5.07, as in the firmware",
     .min = -180.0,
     .max = 180.0,
     .set = [](SensorTruth& truth, const double* n) { truth.declination = degrees(n[0]); }},
    {.name = "sensor-deviation",
     .values = "A1,B1,A2,B2",
     .text = "compass error by iron, in degrees: A1 sin + B1 cos + A2 sin 2 + B2 cos 2 of the true azimuth. Default "
             "6.4,-4.8,1.8,2.4",
     .min = -90.0,
     .max = 90.0,
     .set =
         [](SensorTruth& truth, const double* n) {
             truth.a1 = degrees(n[0]);
             truth.b1 = degrees(n[1]);
             truth.a2 = degrees(n[2]);
             truth.b2 = degrees(n[3]);
         }},
    {.name = "sensor-steel",
     .values = "FROM,TO,DEGREES",
     .text = "steel deflects the compass by DEGREES between these true azimuths, less than a full circle. Default: no "
             "steel",
     .min = -360.0,
     .max = 360.0,
     .set =
         [](SensorTruth& truth, const double* n) {
             truth.steelFrom = degrees(n[0]);
             truth.steelTo = degrees(n[1]);
             truth.steel = degrees(n[2]);
         }},
    {.name = "sensor-per-ampere",
     .values = "DEGREES",
     .text = "compass error in degrees for each ampere of the motors. Default 0",
     .min = -90.0,
     .max = 90.0,
     .set = [](SensorTruth& truth, const double* n) { truth.perAmpere = degrees(n[0]); }},
    {.name = "sensor-noise",
     .values = "DEGREES",
     .text = "noise of both angles, 1 sigma. Default 0.5",
     .min = 0.0,
     .max = 90.0,
     .set = [](SensorTruth& truth, const double* n) { truth.noise = degrees(n[0]); }},
    {.name = "sensor-calibration",
     .values = "SYS,GYR,ACC,MAG",
     .text = "calibration that the sensor reports, 0 to 3 each. Default 3,3,3,3",
     .min = 0.0,
     .max = 3.0,
     .set =
         [](SensorTruth& truth, const double* n) {
             const auto digit = [n](int i) { return static_cast<int>(std::lround(n[i])); };
             truth.calibration = {
                 .system = digit(0), .gyro = digit(1), .accelerometer = digit(2), .magnetometer = digit(3)};
         }},
}};

std::ptrdiff_t expected(const SensorOption& option)
{
    return std::ranges::count(option.values, ',') + 1;
}

std::string help(const SensorOption& option)
{
    return "  --" + std::string(option.name) + ' ' + std::string(option.values) + "\n        " +
           std::string(option.text) + '\n';
}

// The numbers between the commas, up to the first that is invalid or out of range.
std::vector<double> readNumbers(const SensorOption& option, std::string_view text)
{
    std::vector<double> numbers;
    for (;;) {
        const std::size_t comma = text.find(',');
        const auto number = parseFinite(text.substr(0, comma));
        if (!number || *number < option.min || *number > option.max) {
            return {};
        }
        numbers.push_back(*number);
        if (comma == std::string_view::npos) {
            return numbers;
        }
        text.remove_prefix(comma + 1);
    }
}

}  // namespace

const SensorOption* findSensorOption(std::string_view name)
{
    const auto* const found = std::ranges::find(kSensorOptionOptions, name, &SensorOption::name);
    return found != kSensorOptionOptions.end() ? found : nullptr;
}

Result<> takeSensorOption(const SensorOption& option, std::string_view text, SensorTruth& truth)
{
    const std::vector<double> numbers = readNumbers(option, text);
    if (std::ssize(numbers) != expected(option)) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("--%1 \"%2\": expected %3, each %4…%5")
                           .arg(toQString(option.name), toQString(text), toQString(option.values),
                                QString::number(option.min, 'f', 0), QString::number(option.max, 'f', 0)));
    }
    option.set(truth, numbers.data());
    return {};
}

std::string sensorHelp()
{
    std::string text;
    for (const SensorOption& option : kSensorOptionOptions) {
        text += help(option);
    }
    return text;
}

}  // namespace boresight::ctl

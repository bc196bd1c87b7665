// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/geomagnetism/declination.h"
#include "core/orientation/mounting.h"

#include <string>
#include <vector>

// The orientation sensor on the antenna: its connection, its mounting, and how its readings are used. Plain values. The
// MQTT broker has settings of its own.
namespace boresight::profile {

enum class SensorSource
{
    None,
    Serial,
    Mqtt,
    Simulated  // of the built-in simulated mount
};

// A range of true headings, clockwise. In it, steel disturbs the compass in a way that the harmonics do not describe.
struct UnreliableArc
{
    Angle from;
    Angle to;

    bool operator==(const UnreliableArc&) const = default;
};

// The compass error caused by iron: the harmonics of core/calibration/deviation_curve.h and their uncertainty.
struct CompassDeviation
{
    Angle a1;
    Angle b1;
    Angle a2;
    Angle b2;
    Angle sigma;      // of the north that came with them, from the swing or from the Sun since; 0: not known
    Angle elevation;  // of the boom while it was swung: there that sigma holds
    std::vector<UnreliableArc> unreliable;

    bool operator==(const CompassDeviation&) const = default;
};

struct SensorSettings
{
    SensorSource source = SensorSource::None;
    std::string port;  // device of the serial port
    int baud = 115200;
    std::string orientationTopic = "antenna/orientation";
    std::string statusTopic = "antenna/status";
    std::string calibrationTopic = "antenna/calibration";
    orientation::Mounting mounting;
    CompassDeviation deviation;
    geomagnetism::DeclinationBy declinationBy = geomagnetism::DeclinationBy::Sensor;
    Angle declinationInSensor = geomagnetism::kDeclinationInFirmware;
    Angle declination;            // of the site, as typed; east positive
    std::string declinationFile;  // World Magnetic Model (.COF) to compute it from; empty: as typed
    Seconds lost{5.0};
    // The firmware reads the heading five times within 0.8 s, averages, and sends 1.0 s after the first reading: the
    // middle of what it averaged is then 0.6 s old. Its elevation is one reading at the end.
    Seconds latency{0.6};
    Seconds averaging{1.0};
    Angle disagreement = Angle::fromDegrees(10.0);  // from the axes, for disagreementTime
    Seconds disagreementTime{1.5};
    // A, of the motor that draws more: above, its field is taken to turn the needle. A mount that turns needs some: the
    // simulated one up to 3.5 A, at any rate.
    double stillCurrent = 1.0;
    double swingCurrent = 5.0;

    // Whether the sensor subscribes to this topic of the broker. A topic has only one reader: if one of two readers
    // ended, the other would get no more messages.
    [[nodiscard]] bool reads(const std::string& topic) const
    {
        return source == SensorSource::Mqtt &&
               (topic == orientationTopic || topic == statusTopic || topic == calibrationTopic);
    }
    bool operator==(const SensorSettings&) const = default;
};

}  // namespace boresight::profile

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/json_payload.h"
#include "core/orientation/orientation.h"
#include "core/pointing/pointing_model.h"

#include <QByteArray>

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>

// The orientation sensor on the antenna of the simulated mount, with the properties and faults of the real one: the
// declination in its firmware, the average of five readings, the count of turns that a restart clears, and the effect
// of iron on a compass. Pure. Every 0.2 s the true axis position is passed in, and about once a second the sensor sends
// a message.
namespace boresight::sim {

struct SensorTruth
{
    pointing::PointingTerms mount;                 // how the beam truly lies to the axes
    Angle mountingOffset;                          // true azimuth of the beam while the sensor looks to true north
    Angle elevationOffset;                         // elevation of the beam while the sensor reports 0°
    bool faceDown = false;                         // the heading then decreases when the beam turns clockwise
    bool elevationDown = false;                    // its elevation decreases when the beam rises
    Angle declination = Angle::fromDegrees(5.07);  // at the site
    Angle inFirmware = Angle::fromDegrees(5.07);   // the declination that the firmware adds
    // Deviation of the compass by the true heading of the beam: a1 sin + b1 cos + a2 sin 2 + b2 cos 2.
    Angle a1;
    Angle b1;
    Angle a2;
    Angle b2;
    // Steel beside the mount: an additional deviation while the true heading of the beam is in this sector.
    Angle steelFrom;
    Angle steelTo;
    Angle steel;
    Angle perAmpere;                        // deviation per ampere of both motors, whose field moves the needle
    Angle noise = Angle::fromDegrees(0.1);  // 1 sigma of a message, for both angles
    int readings = 5;                       // number of readings in the average
    Seconds delay{0.2};                     // of the message, after the last reading
    orientation::Calibration calibration{.system = 3, .gyro = 3, .accelerometer = 3, .magnetometer = 3};
    int temperature = 27;
};

// The values of the built-in mount that a calibration must find: north is off by 37.4°, the azimuth axis leans by 0.6°,
// the beam is 0.3° off the right angle to the elevation axis, and iron deflects the compass by up to 8° once and 3°
// twice per turn.
[[nodiscard]] SensorTruth truthToBeFound();

enum class SensorFault
{
    None,
    Silent,  // without power or WiFi
    Dead,    // the chip does not answer its board: zeros
    Frozen   // sends one value again and again
};

// Rounded as the firmware prints the values.
struct SensorMessage
{
    UtcTime time;
    double azimuth = 0.0;  // °, may exceed 0…360°
    double elevation = 0.0;
    std::int64_t revolutions = 0;
    int temperature = 0;
    orientation::Calibration calibration;
};

[[nodiscard]] std::string toSentence(const SensorMessage& message);  // "$PATRK,…*HH\r\n"
[[nodiscard]] QByteArray toPayload(const SensorMessage& message, orientation::Topic topic);

class SimulatedSensor
{
public:
    static constexpr std::chrono::milliseconds kReadingPeriod{200};

    explicit SimulatedSensor(const SensorTruth& truth = {}, std::uint32_t seed = 1) : m_truth(truth), m_random(seed) {}

    // May be changed at any time.
    [[nodiscard]] SensorTruth& truth() { return m_truth; }
    void setFault(SensorFault fault) { m_fault = fault; }
    // Power off and on: the count of turns and the average start again.
    void restart();

    // Makes one reading. Returns a message when one is due. `amperes`: both motors together, without sign.
    [[nodiscard]] std::optional<SensorMessage> read(SteadyTime now, UtcTime utc, const AxisPosition& axes,
                                                    double amperes = 0.0);

private:
    struct Due
    {
        SteadyTime at;
        SensorMessage message;
    };
    [[nodiscard]] Angle headingAt(const SkyPointing& beam) const;
    [[nodiscard]] SensorMessage message(const SkyPointing& beam);
    [[nodiscard]] std::int64_t counted(double heading);
    [[nodiscard]] Angle noise();
    [[nodiscard]] std::optional<SensorMessage> takeDue(SteadyTime now);

    SensorTruth m_truth;
    std::mt19937 m_random;
    std::normal_distribution<double> m_normal;
    SensorFault m_fault = SensorFault::None;
    UtcTime m_began{};      // start of the readings in the average
    Angle m_first;          // heading of the first reading
    Angle m_sum;            // sum of the differences to the first reading
    int m_readings = 0;     // number so far
    double m_before = 0.0;  // the last heading that was sent
    std::int64_t m_revolutions = 0;
    std::optional<SensorMessage> m_last;
    std::deque<Due> m_due;
};

}  // namespace boresight::sim

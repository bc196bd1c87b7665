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

// The orientation sensor on the antenna of the simulated mount, with the habits and faults of the real one: its
// firmware's own declination, the average of five readings, the count of turns that a restart forgets, what iron does
// to a compass. Pure: each 0.2 s it is given where the axes truly are, and about once a second it sends a message.
namespace boresight::sim {

struct SensorTruth
{
    pointing::PointingTerms mount;  // how the beam truly lies to the axes; nobody but the sky and the sensor knows
    Angle mountingOffset;           // true azimuth of the beam where the sensor looks to true north
    Angle elevationOffset;          // elevation of the beam where the sensor says 0°
    bool faceDown = false;          // then it counts against the compass
    bool elevationDown = false;     // its elevation falls when the beam rises
    Angle declination = Angle::fromDegrees(5.07);  // of the site
    Angle inFirmware = Angle::fromDegrees(5.07);   // what the firmware adds
    // Deviation of the compass over the true heading of the beam: a1 sin + b1 cos + a2 sin 2 + b2 cos 2.
    Angle a1;
    Angle b1;
    Angle a2;
    Angle b2;
    Angle perAmpere;                        // of both motors: their field turns the needle
    Angle noise = Angle::fromDegrees(0.1);  // 1 sigma of a message, both angles
    int readings = 5;                       // that are averaged
    Seconds delay{0.2};                     // of the message, after the last of them
    orientation::Calibration calibration{.system = 3, .gyro = 3, .accelerometer = 3, .magnetometer = 3};
    int temperature = 27;
};

// What is to be found out about the built-in mount: north is 37.4° off, its axis leans by 0.6°, the beam is 0.3° beside
// the elevation axis' right angle, and iron leads the compass by up to 8° once and 3° twice a turn.
[[nodiscard]] SensorTruth truthToBeFound();

enum class SensorFault
{
    None,
    Silent,  // no power, no WiFi
    Dead,    // the chip does not answer its board: zeros
    Frozen   // one value again and again
};

// As the firmware rounds and prints it.
struct SensorMessage
{
    UtcTime time;
    double azimuth = 0.0;  // °, extended
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

    // May be changed at any time; also while it runs.
    [[nodiscard]] SensorTruth& truth() { return m_truth; }
    void setFault(SensorFault fault) { m_fault = fault; }
    // Its power went off and on: the count of turns begins again, and so does its calibration, unless that is kept.
    void restart();

    // One reading; a message when one is due. `amperes` of both motors together, without sign.
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
    UtcTime m_began{};      // of the readings that are averaged
    Angle m_first;          // heading of the first of them
    Angle m_sum;            // of their differences to the first
    int m_readings = 0;     // so far
    double m_before = 0.0;  // the heading sent last
    std::int64_t m_revolutions = 0;
    std::optional<SensorMessage> m_last;
    std::deque<Due> m_due;
};

}  // namespace boresight::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <QByteArray>

#include <optional>
#include <string>

// The JSON messages that the sensor publishes on its three MQTT topics. The orientation message has no calibration and
// no temperature. PayloadReader adds them from the last messages of the other two topics, while those are young. Qt's
// JSON parser refuses the "nan" that the firmware prints for a value that is not finite. Pure.
namespace boresight::orientation {

enum class Topic
{
    Orientation,
    Status,
    Calibration
};

struct SensorState
{
    std::optional<double> temperature;  // °C, of the sensor's chip
    std::string version;                // of the firmware; older versions do not report it
    std::string bssid;                  // of the WiFi access point that it uses
    std::string unknown;                // unknown members of the message, as JSON; usually empty

    bool operator==(const SensorState&) const = default;
};

[[nodiscard]] Parsed<Orientation> parseOrientation(const QByteArray& payload, SteadyTime arrival);
[[nodiscard]] Parsed<SensorState> parseStatus(const QByteArray& payload);
[[nodiscard]] Parsed<Calibration> parseCalibration(const QByteArray& payload);

struct ReportedState
{
    SensorState value;
    SteadyTime arrival;

    bool operator==(const ReportedState&) const = default;
};

class PayloadReader
{
public:
    // The firmware is designed to send its calibration every 10 s and its status every 60 s. After three missing
    // messages the values are too old.
    static constexpr std::chrono::seconds kCalibrationKept{30};
    static constexpr std::chrono::seconds kStatusKept{180};

    // A value if the message was an orientation. Messages of the other topics are kept for the next orientation. Counts
    // every message.
    [[nodiscard]] Parsed<std::optional<Orientation>> take(Topic topic, const QByteArray& payload, SteadyTime arrival);

    // Counts a message that was refused for a reason outside its text.
    void refuse(Refusal reason) { m_counts.count(reason); }

    [[nodiscard]] const Counts& counts() const { return m_counts; }
    [[nodiscard]] const std::string& firmware() const { return m_firmware; }  // from its status; may be empty
    // The last state, of any age.
    [[nodiscard]] const std::optional<ReportedState>& state() const { return m_state; }

private:
    template <class Value>
    struct Kept
    {
        Value value;
        SteadyTime arrival;
    };
    [[nodiscard]] Parsed<std::optional<Orientation>> read(Topic topic, const QByteArray& payload, SteadyTime arrival);
    [[nodiscard]] Orientation joined(Orientation orientation) const;

    std::optional<Kept<Calibration>> m_calibration;
    std::optional<ReportedState> m_state;
    std::string m_firmware;
    Counts m_counts;
};

}  // namespace boresight::orientation

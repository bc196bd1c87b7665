// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <QByteArray>

#include <optional>
#include <string>

// The JSON messages of the sensor: what it publishes on its three MQTT topics. The orientation's own message has no
// calibration and no temperature, so PayloadReader joins what the other two topics last said, while that is young.
// Qt's own JSON reader refuses the "nan" that the firmware prints for a value that is not finite. Pure.
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
    std::string version;                // of the firmware; older ones do not tell
    std::string bssid;                  // of the WiFi access point that it uses
    std::string unknown;                // what else the message held, as JSON; mostly empty

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
    // The firmware means to send its calibration each 10 s and its status each 60 s: so old that three were missed,
    // they say nothing any more.
    static constexpr std::chrono::seconds kCalibrationKept{30};
    static constexpr std::chrono::seconds kStatusKept{180};

    // A value if the message was an orientation; the other topics are kept for the next one. Counts.
    [[nodiscard]] Parsed<std::optional<Orientation>> take(Topic topic, const QByteArray& payload, SteadyTime arrival);

    // For a reason that is not in its text.
    void refuse(Refusal reason) { m_counts.count(reason); }

    [[nodiscard]] const Counts& counts() const { return m_counts; }
    [[nodiscard]] const std::string& firmware() const { return m_firmware; }  // as its status said; may be empty
    // The last one, whatever its age.
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

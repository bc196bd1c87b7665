// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/json_payload.h"
#include "core/orientation/judge.h"
#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"
#include "core/units/sky.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <optional>

// What the station reports about the orientation sensor. Plain values. They never cause a motion.
namespace boresight {

struct SensorStatus
{
    QString source;  // "serial /dev/ttyUSB0"; empty: the profile has none
    bool open = false;
    QString problem;  // one line: what, where, what to do; empty: no problem
    orientation::Presence presence = orientation::Presence::Awaited;
    bool dead = false;                             // the sensor sends only zeros
    std::optional<orientation::Orientation> last;  // the newest plausible reading, as sent, of any age
    std::optional<std::chrono::milliseconds> age;  // of `last`
    std::optional<SkyPointing> direction;          // true, after all corrections; empty while the sensor is lost
    // Uncertainty of the azimuth in `direction` after a compass swing: the part that is the same in all readings.
    // Empty: it is unknown.
    std::optional<Angle> azimuthSigma;
    // Why the azimuth cannot be used: the compass is not calibrated, or steel disturbs it at this heading. Empty: it
    // can be used.
    QString doubt;
    Angle declination;         // the one used for `direction`
    QString declinationText;   // where it comes from, or why there is none
    QString declinationModel;  // the model: "WMM-2025, of 2025.0 to 2030.0"; empty: none was read
    QString declinationDoubt;  // what is wrong with it: "the model has expired: …"; empty: nothing
    // Sensor minus axes at the time of the measurement, by the shorter way round. Empty: no values to compare.
    std::optional<Angle> azimuthDifference;
    std::optional<Angle> elevationDifference;
    bool disagrees = false;  // the difference was too large for longer than the profile permits
    std::int64_t turns = 0;  // of its heading, since the last gap in its readings
    std::uint64_t outliers = 0;
    std::uint64_t restarts = 0;
    orientation::Counts counts;
    std::optional<orientation::SensorState> firmware;      // its own report, which only comes by MQTT
    std::optional<std::chrono::milliseconds> firmwareAge;  // of `firmware`

    [[nodiscard]] bool configured() const { return !source.isEmpty(); }
    bool operator==(const SensorStatus&) const = default;
};

}  // namespace boresight

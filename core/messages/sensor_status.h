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
    QString problem;  // one line: what, where, what to do; empty while all is well
    orientation::Presence presence = orientation::Presence::Awaited;
    bool dead = false;                             // the sensor sends only zeros
    std::optional<orientation::Orientation> last;  // the newest plausible reading, as sent, of any age
    std::optional<std::chrono::milliseconds> age;  // of that
    std::optional<SkyPointing> direction;          // true, after all corrections; not once it is lost
    // Of the azimuth in `direction`, after a swing: what is the same in all readings; empty: nothing is known of it.
    std::optional<Angle> azimuthSigma;
    // Why its azimuth cannot be used: the compass is not calibrated, or steel disturbs it at this heading. Empty: it
    // can.
    QString doubt;
    Angle declination;         // that is in `direction`
    QString declinationText;   // whose that is, or why there is none
    QString declinationModel;  // that reckons it: "WMM-2025, of 2025.0 to 2030.0"; empty: none was read
    QString declinationDoubt;  // what is wrong with it: "the model has expired: …"; mostly empty
    // Sensor minus axes at the time of the measurement, the shorter way round. Empty: there was nothing to compare.
    std::optional<Angle> azimuthDifference;
    std::optional<Angle> elevationDifference;
    bool disagrees = false;  // the difference is too large for longer than the profile permits
    std::int64_t turns = 0;  // counted from its headings, since it is heard without a gap
    std::uint64_t outliers = 0;
    std::uint64_t restarts = 0;
    orientation::Counts counts;
    std::optional<orientation::SensorState> firmware;      // what it says of itself, by MQTT alone
    std::optional<std::chrono::milliseconds> firmwareAge;  // of that

    [[nodiscard]] bool configured() const { return !source.isEmpty(); }
    bool operator==(const SensorStatus&) const = default;
};

}  // namespace boresight

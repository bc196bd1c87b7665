// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

// The faults that the simulated pair shows on request. Plain values. Each injection has a start on the clock of the
// pair and a duration. Injections can be planned before a run, or added and removed while it runs.
namespace boresight::sim {

enum class FaultKind
{
    Silence,         // the drive receives and acts, but never answers
    LateReply,       // value: seconds
    LostReply,       // value: probability that a reply is lost, 0…1
    LostCommand,     // value: probability that the drive does not receive a frame, 0…1 (1 is a cut cable)
    CorruptLine,     // value: probability that the adapter damages the line of a reply, 0…1
    MissingOk,       // the adapter does not acknowledge
    AdapterError,    // the adapter answers ERR and does not send
    BusOff,          // the adapter is off the bus
    DuplicateId,     // the drive answers with the id of the other drive
    DriveFault,      // value: fault code, at once. It returns at each enabling, as in a real drive. A code of a limit
                     // (96…105) is only reported while the drive is on; the drive still works
    BoardPowerLoss,  // of one drive: a loose plug
    PowerLoss,       // of the whole mount. value: mount angle in degrees to which this axis is turned by hand
    SupplyVoltage,   // value: V
    Wind,            // value: Nm towards larger angles
    Jam,             // value: mount angle in degrees at which something is in the way
    Stall,           // the axis is blocked where it is now
    RegisterMap,     // value: another register map version
    EncoderSlip,     // value: degrees. The measured angle jumps by this much at the start and stays there
    FalsePosition,   // value: degrees by which the angle in a reply is wrong. The drive itself has the right angle
    PositionNaN,
    PositionInfinite,
    PositionMissing,   // the reply ends before the position: it has little more than the mode
    SupplyNaN,         // no voltage in the reply
    TemperatureNaN,    // no temperature of board and motor in the reply
    ForeignId,         // value: the sender id in the reply
    ExchangedReplies,  // the reply has the sender id of the other drive
    DoubledReply,      // each reply comes twice
    StaleReply,        // value: seconds, at most kLongestStale. The reply of that time ago comes again
    EditedReply,       // value: probability that a reply is changed by a kind from FalsePosition to StaleReply
    SensorSilence,     // the orientation sensor is without power, or without WiFi
    SensorDead,        // the chip of the sensor does not answer its board: zeros
    SensorFrozen,      // the sensor sends one value again and again
};

struct Injection
{
    FaultKind kind = FaultKind::Silence;
    std::optional<Axis> axis{};  // empty: both
    Seconds at{0.0};             // on the clock of the pair
    Seconds duration{std::numeric_limits<double>::infinity()};
    std::optional<double> value{};
};

class FaultSchedule
{
public:
    using Handle = std::uint64_t;

    Handle add(const Injection& injection);
    void remove(Handle handle);
    void clear() { m_entries.clear(); }
    [[nodiscard]] bool isEmpty() const { return m_entries.empty(); }

    // The value of the latest active injection of that kind. 0 if the injection has no value.
    [[nodiscard]] std::optional<double> active(FaultKind kind, Axis axis, Seconds now) const;
    [[nodiscard]] bool isActive(FaultKind kind, Axis axis, Seconds now) const
    {
        return active(kind, axis, now).has_value();
    }
    // The injection itself, which separates "no value" from 0.
    [[nodiscard]] const Injection* find(FaultKind kind, Axis axis, Seconds now) const;

private:
    struct Entry
    {
        Handle handle = 0;
        Injection injection;
    };
    std::vector<Entry> m_entries;
    Handle m_next = 1;
};

}  // namespace boresight::sim

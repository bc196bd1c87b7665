// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

// What the simulated pair does wrong on request. Plain values: each injection has a start on the pair's own clock and
// a duration; it can be planned before a run or added and removed while it runs.
namespace boresight::sim {

enum class FaultKind
{
    Silence,         // the drive receives and acts, and never answers
    LateReply,       // value: seconds
    LostReply,       // value: probability that a reply is lost, 0…1
    LostCommand,     // value: probability that the drive does not receive a frame, 0…1 (1 is a cut cable)
    CorruptLine,     // value: probability that the adapter damages the line of a reply, 0…1
    MissingOk,       // the adapter does not acknowledge
    AdapterError,    // the adapter answers ERR and sends nothing
    BusOff,          // the adapter is off the bus
    DuplicateId,     // the drive answers under the other's id
    DriveFault,      // value: fault code, at once; comes back on enabling for as long as it lasts, as it does in a real
                     // drive. A limit's code (96…105) is only told while the drive is on: it goes on working
    BoardPowerLoss,  // of one drive: a loose plug
    PowerLoss,       // of the whole mount; value: mount angle in degrees that a hand turns this axis to
    SupplyVoltage,   // value: V
    Wind,            // value: Nm towards larger angles
    Jam,             // value: mount angle in degrees where something is in the way
    Stall,           // the axis is blocked where it is
    RegisterMap,     // value: another register map version
    EncoderSlip,     // value: degrees that the measured angle jumps by when it begins; the jump stays
    FalsePosition,   // value: degrees that the angle in a reply is wrong by; the drive itself knows better
    PositionNaN,
    PositionInfinite,
    PositionMissing,   // the reply ends before it: little more than the mode
    SupplyNaN,         // no voltage in the reply
    TemperatureNaN,    // neither of the board nor of the motor
    ForeignId,         // value: the id that a reply seems to come from
    ExchangedReplies,  // a reply seems to come from the other drive
    DoubledReply,      // each comes twice
    StaleReply,        // value: seconds, up to kLongestStale; the reply of that time ago comes again
    EditedReply,       // value: probability that one of the kinds from FalsePosition to StaleReply is done to a reply
    SensorSilence,     // the orientation sensor has no power, or no WiFi
    SensorDead,        // its chip does not answer it: zeros
    SensorFrozen,      // it says one value again and again
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

    // The value of the latest active injection of that kind; 0 if it was given none.
    [[nodiscard]] std::optional<double> active(FaultKind kind, Axis axis, Seconds now) const;
    [[nodiscard]] bool isActive(FaultKind kind, Axis axis, Seconds now) const
    {
        return active(kind, axis, now).has_value();
    }
    // The injection itself, to tell "no value" from 0.
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

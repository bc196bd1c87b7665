// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/plan/pass_plan.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <QString>
#include <QStringList>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

// The recording of a pass: what the mount did in each tick, what happened, and the plan. Plain values, any thread.
// Empty: unknown.
namespace boresight::recording {

struct AxisTick
{
    std::optional<Angle> actual;  // of the axis, with its turns
    std::optional<Angle> commanded;
    std::optional<Angle> target;
    std::optional<AngularRate> rate;
    std::optional<AngularRate> commandedRate;
    std::optional<double> torque;            // Nm
    std::optional<double> current;           // A, q axis
    std::optional<double> busVoltage;        // V
    std::optional<double> power;             // W, electrical
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C
    std::optional<int> state;                // its word: Header::axisWord

    bool operator==(const AxisTick&) const = default;
};

struct Tick
{
    UtcTime utc{};
    std::optional<int> state;  // its word: Header::stateWord
    // Where the beam is, where it is commanded to, and where the target is.
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    std::optional<Angle> error;         // between `actual` and `target`
    std::optional<SkyPointing> sensor;  // the beam as the orientation sensor measures it
    std::optional<double> wind;         // m/s
    std::array<AxisTick, 2> axes;       // azimuth, elevation

    [[nodiscard]] const AxisTick& axis(Axis one) const { return axes[index(one)]; }
    bool operator==(const Tick&) const = default;
};

enum class EventKind
{
    Event,
    MotionStart,  // which source moved the mount, and why
    Alarm,
    ClientLine  // a line of a client, with the answer
};

enum class EventLevel
{
    Advisory,
    Warning,
    Alarm
};

struct Event
{
    UtcTime utc{};
    EventKind kind = EventKind::Event;
    EventLevel level = EventLevel::Advisory;
    QString source;  // "operator", "rotctld 127.0.0.1:51234"
    QString text;

    bool operator==(const Event&) const = default;
};

// The ticks from `from` to `to` were not stored, because the disk was too slow or full.
struct Gap
{
    UtcTime from{};
    UtcTime to{};
    std::uint64_t ticks = 0;

    bool operator==(const Gap&) const = default;
};

struct Header
{
    QString program;  // "Boresight 1.0"
    QString mount;    // its name in the profile
    bool isSimulated = false;
    std::optional<Site> site;
    Angle beamWidth;
    QString target;                      // "NOAA 19", or the text of the motion
    std::optional<std::int64_t> number;  // of a satellite
    QString client;                      // who sent the points; empty: Boresight tracks the target by itself
    UtcTime began{};
    int part = 1;            // of a long pass. Each part has a file
    QStringList stateWords;  // "TRACK" by the number Tick::state
    QStringList axisWords;   // "MOVING" by the number AxisTick::state

    [[nodiscard]] QString stateWord(const std::optional<int>& state) const
    {
        return state ? stateWords.value(*state) : QString();
    }
    [[nodiscard]] QString axisWord(const std::optional<int>& state) const
    {
        return state ? axisWords.value(*state) : QString();
    }
    bool operator==(const Header&) const = default;
};

// Other times come from a damaged or foreign file.
[[nodiscard]] constexpr bool isRecordable(UtcTime utc)
{
    constexpr UtcTime kYear2000{std::chrono::sys_days{std::chrono::year{2000} / 1 / 1}};
    constexpr UtcTime kYear2200{std::chrono::sys_days{std::chrono::year{2200} / 1 / 1}};
    return utc >= kYear2000 && utc < kYear2200;
}

// A whole file. Ticks, events and gaps are in the order of the file, which is that of the time.
struct Recording
{
    Header header;
    std::vector<Tick> ticks;
    std::vector<Event> events;
    std::optional<plan::PlanVariant> plan;  // the newest in the file
    std::vector<Gap> gaps;
    bool hasEnd = false;   // the recording ended in the orderly way
    QStringList problems;  // what of the file could not be read, and where. Empty: nothing

    bool operator==(const Recording&) const = default;
};

}  // namespace boresight::recording

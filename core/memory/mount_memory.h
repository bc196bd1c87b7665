// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/memory/host_time.h"
#include "core/messages/crash_stop.h"
#include "core/moteus/count_origin.h"
#include "core/moteus/registers.h"
#include "core/units/quantity.h"

#include <QString>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

// What must outlive the program and the power of the drives: on which turn each axis stood, which drive it was, and how
// it stopped when nobody fed it. One file per mount (memory_file.h). Plain values; mechanical angles. Axis order of the
// arrays: azimuth, elevation.
namespace boresight::memory {

// One axis at one moment.
struct TurnRecord
{
    QString drive;        // its UUID, 8-4-4-4-12 digits
    Angle angle;          // absolute
    MotorTurns reported;  // by the drive, at the same moment
    Angle counted;        // what `reported` stood for by the profile of then; `angle` is whole places away from it
    Seconds uptime{0.0};  // of the drive, at the same moment: proves later that it never lost power since
    moteus::HomeState homeState = moteus::HomeState::Rotor;  // at the same moment
    std::optional<moteus::CountOrigin> origin;               // proves later that nobody set its position since
    UtcTime when;
    HostTime host;        // the same moment: a clock that nobody can put back
    bool moving = false;  // dirty: the axis moved, so it may have come to rest elsewhere

    bool operator==(const TurnRecord&) const = default;

    // It still tells where the axis may be.
    void proveNothing() { host = {}; }
    [[nodiscard]] bool provesNothing() const { return host == HostTime{}; }
};

struct MountMemory
{
    std::array<std::optional<TurnRecord>, 2> turns;
    std::array<std::optional<CrashStop>, 2> crashStops;
    std::optional<UtcTime> placeUsed;  // of the last entered place that was used: each counts once

    bool operator==(const MountMemory&) const = default;
};

}  // namespace boresight::memory

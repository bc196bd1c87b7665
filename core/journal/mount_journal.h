// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/journal/host_time.h"
#include "core/messages/crash_stop.h"
#include "core/moteus/count_origin.h"
#include "core/moteus/registers.h"
#include "core/units/quantity.h"

#include <QString>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

// The facts that must survive the end of the program and a power cut of the drives: the wrap of each axis, the identity
// of its drive, and how it stopped when the commands were cut. One file per mount (journal_file.h). Plain values;
// mechanical angles. Arrays are in the order azimuth, elevation.
namespace boresight::journal {

// The state of one axis at one moment.
struct TurnRecord
{
    QString drive;        // its UUID, 8-4-4-4-12 digits
    Angle angle;          // absolute
    MotorTurns reported;  // by the drive, at the same moment
    // The angle that `reported` meant by the profile at that time; differs from `angle` by whole periods.
    Angle counted;
    Seconds uptime{0.0};  // of the drive, at the same moment: shows later whether the drive kept its power
    moteus::HomeState homeState = moteus::HomeState::Rotor;  // at the same moment
    std::optional<moteus::CountOrigin> origin;               // shows later whether the drive's position was set
    UtcTime when;
    HostTime host;        // at the same moment, by a clock that cannot be set back
    bool moving = false;  // written in motion, so the axis may have stopped elsewhere

    bool operator==(const TurnRecord&) const = default;

    // Makes the record unable to prove anything later. It still shows where the axis may be.
    void proveNothing() { host = {}; }
    [[nodiscard]] bool provesNothing() const { return host == HostTime{}; }
};

struct MountJournal
{
    std::array<std::optional<TurnRecord>, 2> turns;
    std::array<std::optional<CrashStop>, 2> crashStops;
    std::optional<UtcTime> placeUsed;  // time of the last confirmed position that was used: each is used only once

    bool operator==(const MountJournal&) const = default;
};

}  // namespace boresight::journal

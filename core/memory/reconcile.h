// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/memory/mount_memory.h"
#include "core/messages/turn_question.h"
#include "core/moteus/registers.h"
#include "core/pointing/mount_model.h"

#include <QString>

#include <optional>
#include <variant>

// The judgement when a drive is met (again): is the turn of its axis known, or must the operator be asked? Pure.
// Certain is said only where it can be shown; README.md has the reasons. Mechanical angles.
namespace boresight::memory {

// What is known about the drive now.
struct DriveFrame
{
    QString drive;  // its UUID, 8-4-4-4-12 digits
    MotorTurns reported;
    moteus::HomeState homeState = moteus::HomeState::Relative;
    Seconds uptime{0.0};                          // since its boot; starts again at 0 after 49.7 days
    std::optional<moteus::CountOrigin> origin{};  // empty: the drive does not report it
    bool outputEncoder = false;                   // an absolute encoder on the output reports the direction
    Angle period;                                 // between two places that look alike to the drive: ambiguity()
};

// What else speaks for one place or another.
struct Evidence
{
    std::optional<TurnRecord> record;
    QString recordProblem;               // "The journal file is missing."
    std::optional<Angle> sensorHeading;  // of a sensor on the antenna
    UtcTime now;
    HostTime host;                 // the same moment
    bool trusted = false;          // the profile calls the power-up position right
    std::optional<QString> doubt;  // a reason to ask in any case: "The encoder jumped by 12.3°."
};

struct Certain
{
    Angle angle;
    QString why;  // a sentence for the log

    bool operator==(const Certain&) const = default;
};

using Judgement = std::variant<Certain, TurnQuestion>;

// The angle of the axis between two places that look the same to its drive: one turn of the rotor, or of the drive's
// output if an absolute encoder sits there. rotorToOutputRatio as the drive calls it: output turns per rotor turn.
[[nodiscard]] Angle ambiguity(const pointing::AxisGeometry& axis, double rotorToOutputRatio, bool outputEncoder);

[[nodiscard]] Judgement reconcile(const DriveFrame& frame, const Evidence& evidence,
                                  const pointing::AxisGeometry& axis);

// An axis in motion is written down each time that it has gone so far: half of what a place may differ from the journal
// and be proposed. So the record is near enough wherever the power is cut.
[[nodiscard]] Angle journalStep(Angle period);

// The last sentence of the evidence.
[[nodiscard]] QString sensorSentence(const std::optional<Angle>& heading);

// What to remember of an axis whose absolute angle is known.
[[nodiscard]] TurnRecord recordOf(const DriveFrame& frame, Angle angle, const pointing::AxisGeometry& axis, bool moving,
                                  UtcTime now, const HostTime& host);

}  // namespace boresight::memory

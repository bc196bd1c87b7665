// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/journal/mount_journal.h"
#include "core/messages/turn_question.h"
#include "core/moteus/registers.h"
#include "core/pointing/mount_model.h"

#include <QString>

#include <optional>
#include <variant>

// The judgement when a drive is found: the wrap of its axis is known, or the operator must be asked. The result is
// Certain only if that can be proved; README.md gives the reasons. Pure. Mechanical angles.
namespace boresight::journal {

// The present report of the drive.
struct DriveFrame
{
    QString drive;  // its UUID, 8-4-4-4-12 digits
    MotorTurns reported;
    moteus::HomeState homeState = moteus::HomeState::Relative;
    Seconds uptime{0.0};                          // since its boot; starts again at 0 after 49.7 days
    std::optional<moteus::CountOrigin> origin{};  // empty: the drive does not report it
    bool outputEncoder = false;                   // an absolute encoder on the output reports the direction
    Angle period;                                 // between two angles that the drive cannot distinguish: ambiguity()
};

// All other facts that indicate where the axis is.
struct Evidence
{
    std::optional<TurnRecord> record;
    QString recordProblem;               // "The journal file is missing."
    std::optional<Angle> sensorHeading;  // of a sensor on the antenna
    UtcTime now;
    HostTime host;                 // at the same time as `now`
    bool trusted = false;          // by the profile, the power-up position is correct
    std::optional<QString> doubt;  // a reason to ask in any case: "The encoder jumped by 12.3°."
};

struct Certain
{
    Angle angle;
    QString why;  // a sentence for the log

    bool operator==(const Certain&) const = default;
};

using Judgement = std::variant<Certain, TurnQuestion>;

// The axis angle between two positions that the drive cannot distinguish: one turn of the rotor, or one turn of the
// output if there is an absolute encoder on the output. rotorToOutputRatio as in the drive: output turns per rotor
// turn.
[[nodiscard]] Angle ambiguity(const pointing::AxisGeometry& axis, double rotorToOutputRatio, bool outputEncoder);

[[nodiscard]] Judgement reconcile(const DriveFrame& frame, const Evidence& evidence,
                                  const pointing::AxisGeometry& axis);

// A moving axis is recorded each time that it has moved by this angle: half of the difference from the journal at which
// a place is still proposed. So the record is near enough wherever the power is cut.
[[nodiscard]] Angle journalStep(Angle period);

// The last sentence of the evidence.
[[nodiscard]] QString sensorSentence(const std::optional<Angle>& heading);

// The record of an axis whose absolute angle is known.
[[nodiscard]] TurnRecord recordOf(const DriveFrame& frame, Angle angle, const pointing::AxisGeometry& axis, bool moving,
                                  UtcTime now, const HostTime& host);

}  // namespace boresight::journal

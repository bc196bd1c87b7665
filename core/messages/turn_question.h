// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <optional>
#include <vector>

// The possible angles of an axis whose drive knows its position only within one turn of its encoder, with the evidence
// for them. Only the operator can answer which one is right. Plain value; mechanical angles.
namespace boresight {

struct TurnQuestion
{
    std::vector<Angle> candidates;  // in order; empty: the drive knows nothing, an angle must be entered
    std::optional<Angle> proposed;  // the candidate that the evidence supports
    std::vector<QString> evidence;  // one sentence each, for the operator; the last is the sensor's
    Angle period;                   // between two candidates
    Angle movedSince;               // by jogging since the question arose

    bool operator==(const TurnQuestion&) const = default;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <optional>
#include <vector>

// The places an axis may be at when its drive knows the direction only within one turn of its encoder, and what speaks
// for each: a question that only the operator can answer. Plain value; mechanical angles.
namespace boresight {

struct TurnQuestion
{
    std::vector<Angle> candidates;  // in order; empty: the drive knows nothing, an angle must be entered
    std::optional<Angle> proposed;  // the candidate that the evidence speaks for
    std::vector<QString> evidence;  // one sentence each, for the operator; the last is the sensor's
    Angle period;                   // between two candidates
    Angle movedSince;               // by jogging since the question arose

    bool operator==(const TurnQuestion&) const = default;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/night_plan.h"
#include "core/schedule/night_report.h"

#include <optional>

// A moment of an armed schedule that other programs wait for. Plain values.
namespace boresight::schedule {

enum class Moment
{
    BeforeAos,
    Aos,
    Los,  // or the pass ended earlier
    Fault
};

struct PassMoment
{
    Moment moment = Moment::BeforeAos;
    UtcTime utc{};
    std::optional<WatchedPass> pass;  // empty: a fault between two passes
    PassEnd end = PassEnd::Running;   // of the pass, at LOS
    QString why = {};                 // in words: the fault, or why the pass ended before its time

    bool operator==(const PassMoment&) const = default;
};

}  // namespace boresight::schedule

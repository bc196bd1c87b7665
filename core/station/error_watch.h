// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/budget/budget_facts.h"
#include "core/messages/station_status.h"
#include "core/pointing/pointing_model.h"

#include <optional>

// Keeps how exactly the axes followed their set-points, and adds the error budget to a status. Decides nothing. Station
// thread only.
namespace boresight {

// What a status and the stream say about the pointing error. Empty: no direction is aimed at, or the measured position
// is older than half a second. Pure.
[[nodiscard]] std::optional<budget::BudgetFacts> budgetFacts(const StationStatus& status,
                                                             const std::optional<tracking::StreamError>& stream);

class ErrorWatch
{
public:
    // The set-points of a tick and the measured replies to them.
    void keep(const TickSample& sample, const Capabilities& can, const pointing::PointingModel& pointing);
    // Call when the rest of the status is complete.
    void fill(StationStatus& status, const std::optional<tracking::StreamError>& stream, SteadyTime now) const;

private:
    budget::ServoRecord m_servo;
};

}  // namespace boresight

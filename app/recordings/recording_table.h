// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/record_table.h"
#include "core/base/clock.h"
#include "core/recording/recording.h"

#include <QString>

#include <cstddef>
#include <string>
#include <vector>

// A recorded pass as rows for other programs and as lines for a person. Pure.
namespace boresight::ctl {

// The ticks from `first`, at most `count`: time, state and all channels, in the order of the file. A state is its word.
[[nodiscard]] RecordTable tickTable(const recording::Recording& pass, std::size_t first, std::size_t count);
[[nodiscard]] RecordTable eventTable(const recording::Recording& pass);
// The moments of the plan. Without a plan the table has no rows.
[[nodiscard]] RecordTable plannedTable(const recording::Recording& pass);
// What the recording is about, in two columns: key and value.
[[nodiscard]] RecordTable aboutTable(const recording::Recording& pass);

// A line of the replay, and when it is shown after the first tick.
struct ReplayLine
{
    Seconds at{};
    QString text;
};

// One status line for each second of the recording, and a line for each event and each gap.
[[nodiscard]] std::vector<ReplayLine> replayLines(const recording::Recording& pass);

}  // namespace boresight::ctl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <chrono>
#include <deque>
#include <optional>
#include <vector>

// Keeps what the screen still has to get: answers to its requests, a sample of the drives for each tick, new lines of
// the log. A slow screen gets one update at a time. After a stall it gets what it missed, as far as that was kept.
// Station thread only.
namespace boresight {

class ScreenFeed
{
public:
    // After a stall of the screen of up to this time its charts miss nothing. After a longer stall they show a gap. The
    // shortest time span of a chart is this long. At 50 Hz the samples take about 120 kB.
    static constexpr std::chrono::seconds kSamplesKept{10};

    void answer(Answer answer) { m_answers.push_back(std::move(answer)); }
    void keep(const TickSample& sample);
    // Call when the screen has taken the last update, or when it shall get another one before that.
    void want() { m_wanted = true; }
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    // Everything that waits for the screen. Call while isWanted().
    [[nodiscard]] StationUpdate take(StationStatus status, const EventLog& log);

private:
    std::vector<Answer> m_answers;
    std::deque<TickSample> m_samples;  // since the last update
    std::uint64_t m_lastLogSent = 0;
    bool m_wanted = true;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <chrono>
#include <deque>
#include <optional>
#include <vector>

// What waits for the screen: answers to its requests, what the drives did in each tick, new lines of the log. A screen
// that is slow gets one update at a time, and after a stall what it missed, as far as that is kept. Station thread
// only.
namespace boresight {

class ScreenFeed
{
public:
    // The charts of a screen that was stalled for so long miss nothing; after a longer stall they show a gap. It is
    // the shortest time that they show whole, and at 50 Hz some 120 kB.
    static constexpr std::chrono::seconds kSamplesKept{10};

    void answer(Answer answer) { m_answers.push_back(std::move(answer)); }
    void keep(const TickSample& sample);
    // The screen has taken the last update, or shall have one although it has not.
    void want() { m_wanted = true; }
    // All that waits, once it is wanted.
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    [[nodiscard]] StationUpdate take(StationStatus status, const EventLog& log);

private:
    std::vector<Answer> m_answers;
    std::deque<TickSample> m_samples;  // since the last update
    std::uint64_t m_lastLogSent = 0;
    bool m_wanted = true;
};

}  // namespace boresight

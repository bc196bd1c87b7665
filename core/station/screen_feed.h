// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/clients/protocol_log.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <chrono>
#include <deque>
#include <optional>
#include <vector>

// Keeps everything that the screen has not got yet: answers to its requests, one sample of the drives for each tick,
// new lines of the log and of the protocol log. Only one update is on its way to the screen at a time. After a stall
// the screen gets the kept part of what it missed. Station thread only.
namespace boresight {

class ScreenFeed
{
public:
    // If the screen stalls for less than this time, its charts have no gap. The shortest time span of a chart is this
    // long. At 50 Hz the samples take about 120 kB.
    static constexpr std::chrono::seconds kSamplesKept{10};

    void answer(Answer answer) { m_answers.push_back(std::move(answer)); }
    void keep(const TickSample& sample);
    // The screen has taken the last update, or must get the next one at once.
    void want() { m_wanted = true; }
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    // Everything that waits for the screen. Call while isWanted().
    [[nodiscard]] StationUpdate take(StationStatus status, const EventLog& log, const ProtocolLog& protocol);

private:
    std::vector<Answer> m_answers;
    std::deque<TickSample> m_samples;  // since the last update
    std::uint64_t m_lastLogSent = 0;
    std::uint64_t m_lastProtocolSent = 0;
    bool m_wanted = true;
};

}  // namespace boresight

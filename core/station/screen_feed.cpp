// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/screen_feed.h"

#include <utility>

namespace boresight {
namespace {

// Nobody reads more lines at once. The log file has all of them.
constexpr std::size_t kMostLogLines = 500;

}  // namespace

void ScreenFeed::keep(const TickSample& sample)
{
    m_samples.push_back(sample);
    while (m_samples.back().time - m_samples.front().time >= kSamplesKept) {
        m_samples.pop_front();
    }
}

StationUpdate ScreenFeed::take(StationStatus status, const EventLog& log, const ProtocolLog& protocol)
{
    m_wanted = false;
    StationUpdate update{.status = std::move(status),
                         .log = log.since(m_lastLogSent, kMostLogLines),
                         .answers = std::exchange(m_answers, {}),
                         .samples = {m_samples.begin(), m_samples.end()},
                         .protocol = protocol.newest(m_lastProtocolSent, ProtocolLog::kCapacity)};
    m_samples.clear();
    m_lastProtocolSent = protocol.lastNumber();
    m_lastLogSent = log.lastNumber();
    return update;
}

}  // namespace boresight

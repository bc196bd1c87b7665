// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/command_rate.h"

#include <algorithm>

namespace boresight::rotctld {

std::int64_t CommandRate::secondAt(SteadyTime now) const
{
    return std::chrono::floor<std::chrono::seconds>(now - m_begin).count();
}

void CommandRate::count(SteadyTime now)
{
    const std::int64_t number = secondAt(now);
    Second& second = m_seconds[static_cast<std::size_t>(number) % m_seconds.size()];
    if (second.number != number) {
        second = {.number = number};
    }
    ++second.commands;
}

// Counts complete seconds, so that a steady client shows a steady number. In the first second, counts what there is.
double CommandRate::perSecond(SteadyTime now) const
{
    const std::int64_t running = secondAt(now);
    const std::int64_t whole = std::min<std::int64_t>(running, kSeconds);
    std::uint32_t commands = 0;
    for (const Second& second : m_seconds) {
        const bool counts =
            whole == 0 ? second.number == running : second.number >= running - whole && second.number < running;
        commands += counts ? second.commands : 0;
    }
    return static_cast<double>(commands) / static_cast<double>(std::max<std::int64_t>(whole, 1));
}

}  // namespace boresight::rotctld

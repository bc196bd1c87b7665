// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/axis_observer.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight {

void AxisObserver::tick()
{
    const auto sample = m_control.sample();
    if (!m_control.measured() || !sample) {
        m_trace.clear();
    } else if (const auto& [azimuth, elevation] = sample->axes; azimuth.actual && elevation.actual) {
        m_trace.note(sample->time, {*azimuth.actual, *elevation.actual},
                     std::max(std::abs(azimuth.current.value_or(0.0)), std::abs(elevation.current.value_or(0.0))));
    }
    m_unseenSince = now() ? std::nullopt : std::optional(m_unseenSince.value_or(m_clock.now()));
}

Seconds AxisObserver::unseenFor() const
{
    return m_unseenSince ? Seconds(m_clock.now() - *m_unseenSince) : Seconds(0.0);
}

Result<> AxisObserver::standStill() const
{
    return m_control.measured().and_then([&](const AxisPosition&) -> Result<> {
        const auto moves = [this](Axis axis) { return m_control.isSeenToMove(axis); };
        if (!now() || std::ranges::any_of(kAxes, moves)) {
            return failure(ErrorCode::Refused, Text::tr("Wait until the mount stands still."));
        }
        return {};
    });
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/helm.h"

#include <optional>

// Waits when the reports of a tracked target are missing. The mount stands still and an alarm is raised. If a report
// arrives within kLongest, the mount continues by itself. After that the tracking ends, because the mount must not
// start by itself later. Station thread only.
namespace boresight::sources {

class StaleWait
{
public:
    // The longest time to wait for a report.
    static constexpr std::chrono::minutes kLongest{2};

    // The alarm takes two arguments: what is wrong, and the time until which the mount may continue by itself.
    StaleWait(Helm& helm, const AlarmEntry& alarm) : m_helm(helm), m_alarm(alarm) {}

    [[nodiscard]] bool isWaiting() const { return m_since.has_value(); }
    // Call once in each tick without a usable report. True: the wait lasted too long.
    [[nodiscard]] bool isTooLong(const QString& why, SteadyTime now);
    // Call when a report has arrived or the tracking ends.
    void end();

private:
    Helm& m_helm;
    const AlarmEntry& m_alarm;
    std::optional<SteadyTime> m_since;
};

}  // namespace boresight::sources

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/helm.h"

#include <optional>

// What is followed is not reported any more: the mount stands still, with an alarm, and goes on by itself if a report
// comes soon. What is not there after a while is a fault: the mount must not start by itself later. Station thread
// only.
namespace boresight::sources {

class StaleWait
{
public:
    // Reports are waited for no longer than this.
    static constexpr std::chrono::minutes kLongest{2};

    // The alarm has two arguments: what is wrong, and until when the mount goes on by itself.
    StaleWait(Helm& helm, const AlarmEntry& alarm) : m_helm(helm), m_alarm(alarm) {}

    [[nodiscard]] bool isWaiting() const { return m_since.has_value(); }
    // Once in a tick without a report. True: it lasted too long.
    [[nodiscard]] bool isTooLong(const QString& why, SteadyTime now);
    // There is a report again, or nothing is followed.
    void end();

private:
    Helm& m_helm;
    const AlarmEntry& m_alarm;
    std::optional<SteadyTime> m_since;
};

}  // namespace boresight::sources

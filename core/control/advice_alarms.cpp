// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/advice_alarms.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

#include <algorithm>
#include <utility>

namespace boresight {

void AdviceAlarms::update(const profile::Profile& profile)
{
    const auto advice = profile::adviceOn(profile);
    if (advice == m_advice) {
        return;
    }
    for (const profile::Advice& old : std::exchange(m_advice, advice)) {
        m_alarms.clear(alarmEntry("profile.advice").of(toQString(old.key)));
    }
    for (const profile::Advice& one : m_advice) {
        m_alarms.raise(alarmEntry("profile.advice").of(toQString(one.key)), {one.what, one.remedy});
    }
}

void AdviceAlarms::explain(const Capabilities& capabilities)
{
    if (std::ranges::any_of(capabilities.axes, [](const auto& can) { return can && !can->watchdog; })) {
        m_alarms.raise(alarmEntry("mount.no-watchdog"));
    }
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/trial_run.h"

#include "core/base/text.h"

namespace boresight::sources {

Result<> TrialRun::ask(const request::Trial& wanted, const Source& by)
{
    return helm().runAt(wanted.rates, Activity::Trying, by, Text::tr("tuning run")).map([&] {
        m_deadline = helm().now() + kJogKeepAlive;
    });
}

void TrialRun::step(SteadyTime now)
{
    if (helm().current().is(Activity::Trying) && now > m_deadline) {
        helm().end(Severity::Warning, Text::tr("the tuning run ended because it received no new rate"));
    }
}

}  // namespace boresight::sources

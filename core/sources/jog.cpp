// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/jog.h"

#include "core/base/text.h"

namespace boresight::sources {

Result<> Jog::ask(const request::Jog& wanted, const Source& by)
{
    if (wanted.rates == AxisRates{}) {
        if (helm().current().is(Activity::Jogging) && helm().current().isFor(by)) {
            helm().hold(Activity::Holding);
        }
        return {};
    }
    return helm().runAt(wanted.rates, Activity::Jogging, by, Text::tr("jog")).map([&] {
        m_deadline = helm().now() + kJogKeepAlive;
    });
}

void Jog::step(SteadyTime now)
{
    if (helm().current().is(Activity::Jogging) && now > m_deadline) {
        helm().end(Severity::Warning, Text::tr("jog ends because its keep-alive did not come"));
    }
}

}  // namespace boresight::sources

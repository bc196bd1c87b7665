// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/command_budget.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::rotctld {

void CommandBudget::count(SteadyTime now)
{
    if (now - m_second >= std::chrono::seconds(1)) {
        m_second = now;
        m_inSecond = 0;
    }
    m_inSecond = std::min(m_inSecond + 1, kPerSecond + 2);
}

Result<> CommandBudget::admits() const
{
    if (m_inSecond > kPerSecond) {
        return failure(
            ErrorCode::Busy,
            Text::tr("More than %1 commands arrived in one second. Boresight ignores the rest.").arg(kPerSecond));
    }
    return {};
}

}  // namespace boresight::rotctld

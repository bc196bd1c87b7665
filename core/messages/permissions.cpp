// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/permissions.h"

#include "core/base/text.h"

namespace boresight {

Permissions::Permissions() : Permissions(Text::tr("The station has not reported yet.")) {}

void Permissions::refuse(Action action, const QString& why)
{
    if (why.isEmpty()) {
        return;
    }
    if (!m_reasons) {
        m_reasons = new Reasons;
        m_reasons->of.fill(m_ofAll);
    }
    m_reasons->of[static_cast<std::size_t>(action)] = why;
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/admission.h"

#include "core/base/text.h"

#include <utility>

namespace boresight::rotctld {

QString Admission::crowd(const std::string& host, std::size_t most) const
{
    if (m_served >= most) {
        return Text::tr("refused: %1 clients are connected").arg(QString::number(m_served));
    }
    // A program that connects again and again must not keep other computers out, so a quarter of the places is left to
    // them.
    const auto found = m_servedOf.find(host);
    if (found != m_servedOf.end() && found->second >= most - most / 4) {
        return Text::tr("refused: %1 clients of its host are connected").arg(QString::number(found->second));
    }
    return {};
}

bool Admission::isCrowdNews()
{
    return !std::exchange(m_crowdTold, true);
}

void Admission::enter(const std::string& host)
{
    ++m_served;
    ++m_servedOf[host];
}

void Admission::leave(const std::string& host)
{
    --m_served;
    const auto found = m_servedOf.find(host);
    if (found != m_servedOf.end() && --found->second == 0) {
        m_servedOf.erase(found);
    }
    m_crowdTold = false;
}

}  // namespace boresight::rotctld

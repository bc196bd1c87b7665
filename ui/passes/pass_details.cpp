// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_details.h"

#include "core/passes/pass_light.h"
#include "core/targets/pass_way.h"

namespace boresight::ui {

targets::CableTurns cableOf(const BookedPass& one, const PassBook& book)
{
    return targets::cableTurns(*targets::wayOf(one.pass, book.elementsOf(one), book.site), book.antennaOf(one).reach);
}

void PassDetails::begin(const std::shared_ptr<const PassBook>& book)
{
    m_book = book;
    m_sunlit.clear();
    m_cable.clear();
}

Seconds PassDetails::sunlit(std::size_t pass)
{
    auto found = m_sunlit.find(pass);
    if (found == m_sunlit.end()) {
        const BookedPass& one = m_book->passes.at(pass);
        const passes::PassLight light = passes::lightOf(one.pass, m_book->elementsOf(one), m_book->site);
        found = m_sunlit.emplace(pass, passes::sunlitTime(one.pass, light)).first;
    }
    return found->second;
}

const targets::CableTurns& PassDetails::cable(std::size_t pass)
{
    auto found = m_cable.find(pass);
    if (found == m_cable.end()) {
        found = m_cable.emplace(pass, cableOf(m_book->passes.at(pass), *m_book)).first;
    }
    return found->second;
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_details.h"

#include "core/targets/pass_way.h"

#include <algorithm>

namespace boresight::ui {

targets::CableTurns cableOf(const BookedPass& one, const PassBook& book)
{
    return targets::cableTurns(*targets::wayOf(one.pass, book.elementsOf(one), book.site), book.antennaOf(one).reach);
}

PassDetails::PassDetails(QObject* parent) : QObject(parent)
{
    m_idle.setInterval(0);
    connect(&m_idle, &QTimer::timeout, this, &PassDetails::workOne);
}

void PassDetails::begin(const std::shared_ptr<const PassBook>& book)
{
    m_book = book;
    m_facts.clear();
    m_order.clear();
    m_wanted.clear();
    m_idle.stop();
}

const PassDetails::Facts* PassDetails::find(std::size_t pass)
{
    if (const auto found = m_facts.find(pass); found != m_facts.end()) {
        return &found->second;
    }
    if (std::ranges::find(m_wanted, pass) == m_wanted.end()) {
        m_wanted.push_front(pass);
        m_wanted.resize(std::min(m_wanted.size(), kMostWanted));
        m_idle.start();
    }
    return nullptr;
}

void PassDetails::workOne()
{
    const std::size_t pass = m_wanted.front();
    m_wanted.pop_front();
    if (m_wanted.empty()) {
        m_idle.stop();
    }
    if (m_order.size() == kMostKept) {
        m_facts.erase(m_order.front());
        m_order.pop_front();
    }
    const BookedPass& one = m_book->passes.at(pass);
    const passes::PassLight light = passes::lightOf(one.pass, m_book->elementsOf(one), m_book->site);
    m_facts[pass] = {.light = light, .sunlit = passes::sunlitTime(one.pass, light), .cable = cableOf(one, *m_book)};
    m_order.push_back(pass);
    Q_EMIT workedOut(pass);
}

}  // namespace boresight::ui

#include "moc_pass_details.cpp"

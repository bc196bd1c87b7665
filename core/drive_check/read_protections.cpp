// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/read_protections.h"

#include <algorithm>
#include <utility>

namespace boresight::drive_check {

ReadProtections::ReadProtections(std::vector<Protection> wanted) : m_wanted(std::move(wanted))
{
    forget();
}

void ReadProtections::want(std::vector<Protection> wanted)
{
    std::vector<Reading> readings;
    for (const Protection& one : wanted) {
        const auto found = std::ranges::find(m_wanted, one.key, &Protection::key);
        const auto place = static_cast<std::size_t>(found - m_wanted.begin());
        readings.push_back(found != m_wanted.end() ? m_readings[place] : Reading{});
    }
    m_wanted = std::move(wanted);
    m_readings = std::move(readings);
    judge();
}

void ReadProtections::take(std::vector<Reading> readings)
{
    m_readings = std::move(readings);
    judge();
}

void ReadProtections::forget()
{
    m_readings.assign(m_wanted.size(), {});
    judge();
}

void ReadProtections::judge()
{
    m_lines.clear();
    for (std::size_t i = 0; i < m_wanted.size(); ++i) {
        m_lines.push_back(judged(m_wanted[i], m_readings[i]));
    }
}

bool ReadProtections::isAllRead() const
{
    return std::ranges::none_of(m_readings, [](const Reading& one) { return one.state == Reading::State::Unread; });
}

bool ReadProtections::isAnyFixable() const
{
    return std::ranges::any_of(m_lines, [](const ProtectionLine& line) { return !line.fix.isEmpty(); });
}

std::optional<double> ReadProtections::value(std::string_view key) const
{
    const auto found = std::ranges::find(m_wanted, key, &Protection::key);
    const auto place = found - m_wanted.begin();
    return found != m_wanted.end() ? m_readings[static_cast<std::size_t>(place)].value() : std::nullopt;
}

}  // namespace boresight::drive_check

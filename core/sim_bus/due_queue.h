// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <map>
#include <optional>

// Items with a due time, in the order of their times. Items of the same time come in the order of adding.
namespace boresight::sim {

template <class T>
class DueQueue
{
public:
    void add(Seconds due, const T& item) { m_items.emplace(due, item); }
    [[nodiscard]] std::optional<T> takeDue(Seconds now)
    {
        if (m_items.empty() || m_items.begin()->first > now) {
            return std::nullopt;
        }
        return std::move(m_items.extract(m_items.begin()).mapped());
    }
    [[nodiscard]] std::optional<Seconds> nextDue() const
    {
        return m_items.empty() ? std::nullopt : std::optional(m_items.begin()->first);
    }
    void clear() { m_items.clear(); }

private:
    std::multimap<Seconds, T> m_items;
};

}  // namespace boresight::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>

// How many commands a second a client sends, over the last seconds. One addition per command; pure.
namespace boresight::rotctld {

class CommandRate
{
public:
    static constexpr int kSeconds = 5;

    explicit CommandRate(SteadyTime begin) : m_begin(begin) {}

    void count(SteadyTime now);
    [[nodiscard]] double perSecond(SteadyTime now) const;

private:
    struct Second
    {
        std::int64_t number = -1;  // since the begin
        std::uint32_t commands = 0;
    };

    [[nodiscard]] std::int64_t secondAt(SteadyTime now) const;

    SteadyTime m_begin;
    std::array<Second, kSeconds + 1> m_seconds{};  // the running one and those before it
};

}  // namespace boresight::rotctld

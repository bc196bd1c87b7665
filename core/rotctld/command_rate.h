// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>

// The number of commands per second of a client, over the last seconds. One addition per command. Pure.
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
        std::int64_t number = -1;  // counted from m_begin
        std::uint32_t commands = 0;
    };

    [[nodiscard]] std::int64_t secondAt(SteadyTime now) const;

    SteadyTime m_begin;
    std::array<Second, kSeconds + 1> m_seconds{};  // the current second and those before it
};

}  // namespace boresight::rotctld

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

// Bounds the commands of one sender in each second, so that its flood does not keep the station busy. Pure.
namespace boresight::rotctld {

class CommandBudget
{
public:
    static constexpr int kPerSecond = 20;

    explicit CommandBudget(SteadyTime begin) : m_second(begin) {}

    void count(SteadyTime now);
    // Error Busy: the last counted command was one too many in its second.
    [[nodiscard]] Result<> admits() const;
    // As admits(), but false for the first such command, so that its sender learns the reason.
    [[nodiscard]] bool isFlood() const { return m_inSecond > kPerSecond + 1; }

private:
    SteadyTime m_second;  // start of the current second
    int m_inSecond = 0;   // commands in this second
};

}  // namespace boresight::rotctld

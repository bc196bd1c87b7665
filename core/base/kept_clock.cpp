// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/kept_clock.h"

namespace boresight {

UtcTime KeptClock::utc() const
{
    const UtcTime computer = m_computer.utc();
    const UtcTime before = goneOn();
    return std::chrono::abs(computer - before) > kSet ? before : computer;
}

Seconds KeptClock::ahead() const
{
    const UtcTime::duration ahead = m_computer.utc() - goneOn();
    return std::chrono::abs(ahead) > kSet ? Seconds(ahead) : Seconds(0.0);
}

bool KeptClock::synchronised() const
{
    return ahead() == Seconds(0.0) && m_computer.synchronised();
}

std::optional<Seconds> KeptClock::error() const
{
    return ahead() == Seconds(0.0) ? m_computer.error() : std::nullopt;
}

bool KeptClock::isConfirmed() const
{
    const std::optional<Seconds> error = m_computer.error();
    return m_computer.synchronised() && error && *error < kSet;
}

void KeptClock::follow()
{
    m_offset = m_computer.utc() - running();
}

UtcTime KeptClock::running() const
{
    return UtcTime(std::chrono::duration_cast<UtcTime::duration>(m_computer.now().time_since_epoch()));
}

}  // namespace boresight

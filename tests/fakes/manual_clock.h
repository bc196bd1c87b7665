// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// A clock turned by hand; both times advance together, unless somebody sets the UTC.
namespace boresight::fakes {

class ManualClock final : public Clock
{
public:
    [[nodiscard]] SteadyTime now() const override { return m_now; }
    [[nodiscard]] UtcTime utc() const override { return m_utc; }
    void advance(Seconds time)
    {
        m_now += std::chrono::duration_cast<SteadyTime::duration>(time);
        m_utc += std::chrono::duration_cast<UtcTime::duration>(time);
    }
    void stepUtc(Seconds by) { m_utc += std::chrono::duration_cast<UtcTime::duration>(by); }

private:
    SteadyTime m_now{std::chrono::hours(1)};
    UtcTime m_utc{std::chrono::sys_days{std::chrono::year{2026} / 11 / 21}};
};

}  // namespace boresight::fakes

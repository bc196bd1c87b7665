// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"

#include <optional>

// Whether the UTC of this computer can be relied on. A computer without a battery starts at any date until a time
// source sets its clock. Station thread only.
namespace boresight {

class ClockTrust
{
public:
    // The kernel reports a clock as not synchronised some 9 hours after its time source is gone. The clock goes on well
    // for longer than that: at 50 ppm it is 4 s off after this time.
    static constexpr std::chrono::hours kKeeps{24};
    // A leap second is no reason to doubt, nor is a small correction.
    static constexpr std::chrono::seconds kStep{10};
    // No clock that shows an earlier time is right: this program was written later.
    static constexpr UtcTime kEarliest{std::chrono::sys_days{std::chrono::year{2026} / 1 / 1}};

    // Call it often: it notices when the clock is set while nothing vouches for it.
    [[nodiscard]] bool update(const Clock& clock, profile::SunClock needed);

private:
    struct Vouched
    {
        SteadyTime when;
        UtcTime::duration offset;  // of UTC from steady time
    };
    std::optional<Vouched> m_vouched;
};

}  // namespace boresight

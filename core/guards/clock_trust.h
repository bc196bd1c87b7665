// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"

#include <optional>

// Whether the UTC of this computer is reliable. A computer without a battery-backed clock starts at any date, until a
// time source sets its clock. Station thread only.
namespace boresight {

class ClockTrust
{
public:
    // The kernel reports a clock as not synchronised some 9 hours after the last contact with its time source. The
    // clock stays good for longer: with an error of 50 ppm it is 4 s off after this time.
    static constexpr std::chrono::hours kKeeps{24};
    // A smaller step is a leap second or a correction, and no reason to doubt the clock.
    static constexpr std::chrono::seconds kStep{10};
    // An earlier time cannot be right, because this program was written later.
    static constexpr UtcTime kEarliest{std::chrono::sys_days{std::chrono::year{2026} / 1 / 1}};

    // Call it often, so that it notices when the clock is set while no time source is in contact.
    [[nodiscard]] bool update(const Clock& clock, profile::SunClock needed);

private:
    struct Vouched
    {
        SteadyTime when;
        UtcTime::duration offset;  // UTC minus steady time
    };
    std::optional<Vouched> m_vouched;
};

}  // namespace boresight

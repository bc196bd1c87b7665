// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/control/clock_trust.h"
#include "core/ephemeris/almanac.h"
#include "core/pointing/region.h"
#include "core/profile/in_force.h"

#include <optional>
#include <vector>

// Where the Sun is now, as far as the profile wants the beam away from it, and the part of the sky that is forbidden
// for it until it is looked for again. Without a clock to rely on that is every place that the Sun can have. The angle
// of an axis that the mount does not have may be any, as in the region. Station thread only.
namespace boresight {

class SunWatch
{
public:
    // How long one keep-out serves, and how much wider it is for that: the Sun goes 0.084° meanwhile, and the air may
    // bend its light by 0.1° more or less than an ordinary one.
    static constexpr std::chrono::seconds kRenewal{20};
    static constexpr Angle kMargin = Angle::fromDegrees(0.2);

    // The profile outlives this.
    explicit SunWatch(const profile::InForce& profile);

    // Of another Sun or site: looks for it with the next update().
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Beams that point this far from the one in use are kept away as well.
    void setSpread(Angle spread);
    // Looks for the Sun when it is time, or when the clock was set; true when the keep-outs have changed.
    [[nodiscard]] bool update(const Clock& clock);

    // Empty when the profile does not want it, and while the Sun is down.
    [[nodiscard]] const std::vector<pointing::KeepOut>& keepOuts() const { return m_keepOuts; }
    // The Sun is to be kept away from, and no clock gives its position.
    [[nodiscard]] bool clockDoubted() const { return m_doubted; }
    // While the clock is doubted: the beam is where the Sun can be, not at the edge of that.
    [[nodiscard]] bool mayBeAt(const SkyPointing& beam, std::optional<Axis> missing) const;
    // How far a beam is from the middle of the Sun, at least; empty without a keep-out, and while the clock is doubted.
    [[nodiscard]] std::optional<Angle> distance(const SkyPointing& beam, std::optional<Axis> missing) const;
    [[nodiscard]] Angle radius() const { return m_profile->sun.radius; }

private:
    void begin();
    [[nodiscard]] std::vector<pointing::KeepOut> around(UtcTime utc);
    [[nodiscard]] Angle keptFree() const;

    const profile::InForce& m_profile;
    ClockTrust m_trust;
    std::optional<ephemeris::Almanac> m_almanac;  // while the Sun is watched
    std::optional<UtcTime> m_looked;
    bool m_doubted = false;
    Angle m_spread;
    SkyPointing m_direction;  // where it appeared then
    std::vector<pointing::KeepOut> m_keepOuts;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/ephemeris/almanac.h"
#include "core/guards/clock_trust.h"
#include "core/pointing/region.h"
#include "core/profile/in_force.h"

#include <optional>
#include <vector>

// Computes where the Sun is, and which part of the sky is forbidden because of it until the next computation. It does
// so only if the profile keeps the beam away from the Sun. While the clock is doubted, every place where the Sun can
// ever be is forbidden. If the mount lacks an axis, every angle of that axis counts, as in the region. Station thread
// only.
namespace boresight {

class SunWatch
{
public:
    // How long one keep-out is used, and how much wider it is because of that. In this time the Sun moves by 0.084°.
    // The refraction may differ by 0.1° from that of standard air.
    static constexpr std::chrono::seconds kRenewal{20};
    static constexpr Angle kMargin = Angle::fromDegrees(0.2);

    // The profile outlives this.
    explicit SunWatch(const profile::InForce& profile);

    // After a change of the Sun settings or the site, the next update() computes the Sun again.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // The keep-out also protects beams that point up to this angle away from the beam in use.
    void setSpread(Angle spread);
    // Computes the Sun when it is time, or when the clock was set. Returns true when the keep-outs have changed.
    [[nodiscard]] bool update(const Clock& clock);

    // Empty when the profile wants no keep-out, and while the Sun is below the horizon.
    [[nodiscard]] const std::vector<pointing::KeepOut>& keepOuts() const { return m_keepOuts; }
    // The profile keeps the beam away from the Sun, but the clock is doubted, so the position of the Sun is unknown.
    [[nodiscard]] bool clockDoubted() const { return m_doubted; }
    // True while the clock is doubted and the beam is where the Sun can be. The edge of that band does not count.
    [[nodiscard]] bool mayBeAt(const SkyPointing& beam, std::optional<Axis> missing) const;
    // The smallest possible angle between a beam and the middle of the Sun. Empty without a keep-out, and while the
    // clock is doubted.
    [[nodiscard]] std::optional<Angle> distance(const SkyPointing& beam, std::optional<Axis> missing) const;
    [[nodiscard]] Angle radius() const { return m_profile->sun.radius; }

private:
    void begin();
    [[nodiscard]] std::vector<pointing::KeepOut> around(UtcTime utc);
    [[nodiscard]] Angle keptFree() const;

    const profile::InForce& m_profile;
    ClockTrust m_trust;
    std::optional<ephemeris::Almanac> m_almanac;  // only while the Sun is watched
    std::optional<UtcTime> m_looked;
    bool m_doubted = false;
    Angle m_spread;
    SkyPointing m_direction;  // where the Sun appeared at m_looked
    std::vector<pointing::KeepOut> m_keepOuts;
};

}  // namespace boresight

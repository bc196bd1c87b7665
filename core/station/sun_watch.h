// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/ephemeris/almanac.h"
#include "core/pointing/region.h"
#include "core/profile/profile.h"

#include <optional>

// Where the Sun is now, as far as the profile wants the beam away from it, and the part of the sky that is forbidden
// for it until it is looked for again. Station thread only.
namespace boresight {

class SunWatch
{
public:
    // How long one keep-out serves, and how much wider it is for that: the Sun goes 0.084° meanwhile, and the air may
    // bend its light by 0.1° more or less than an ordinary one.
    static constexpr std::chrono::seconds kRenewal{20};
    static constexpr Angle kMargin = Angle::fromDegrees(0.2);

    explicit SunWatch(const profile::Profile& profile) { setProfile(profile); }

    void setProfile(const profile::Profile& profile);
    // Looks for the Sun when it is time, or when the clock was set; true when the keep-out has changed.
    [[nodiscard]] bool update(UtcTime utc);

    // Empty when the profile does not want it, and while the Sun is down.
    [[nodiscard]] const std::optional<pointing::KeepOut>& keepOut() const { return m_keepOut; }
    // How far a beam is from the middle of the Sun; empty without a keep-out.
    [[nodiscard]] std::optional<Angle> distance(const SkyPointing& beam) const;
    [[nodiscard]] Angle radius() const { return m_sun.radius; }

private:
    profile::SunSettings m_sun;
    profile::SiteSettings m_site;
    std::optional<ephemeris::Almanac> m_almanac;  // while the Sun is watched
    std::optional<UtcTime> m_looked;
    SkyPointing m_direction;  // where it appeared then
    std::optional<pointing::KeepOut> m_keepOut;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/control/control_parts.h"
#include "core/ephemeris/almanac.h"

#include <optional>

// The direction of the Moon between the steps of azel.dat. While the Moon that Boresight computes agrees with the file,
// the computed Moon is used, else the last step of the file. Computing the Moon needs the site. Station thread only.
namespace boresight::sources {

class AzelMoon
{
public:
    // Call once in each tick, before the other functions.
    void look(const ControlParts& view, const azel::AzelFeed& feed);

    // The angle between the Moon of the file and the computed Moon. Empty if one of them is missing.
    [[nodiscard]] const std::optional<Angle>& apart() const { return m_apart; }
    [[nodiscard]] bool interpolates() const;
    [[nodiscard]] bool differs() const;
    [[nodiscard]] bool isElsewhere() const;
    // Call only after the file has been read.
    [[nodiscard]] SkyPointing at(UtcTime utc);
    // The angular rate across the sky. Empty while the steps of the file are used.
    [[nodiscard]] std::optional<AngularRate> skyRate(UtcTime utc);
    // The next moonrise or moonset. Empty if there is none within a day, or without a site.
    [[nodiscard]] std::optional<UtcTime> nextRise(UtcTime from);
    [[nodiscard]] std::optional<UtcTime> nextSet(UtcTime from);

private:
    std::optional<ephemeris::Almanac> m_almanac;
    std::optional<Site> m_site;  // for which m_almanac computes
    SkyPointing m_step;          // the last step of the file
    UtcTime m_compared{};        // the time in the file when m_apart was computed
    std::optional<Angle> m_apart;
};

}  // namespace boresight::sources

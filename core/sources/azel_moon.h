// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/control/control_parts.h"
#include "core/ephemeris/almanac.h"
#include "core/targets/target_path.h"

#include <optional>

// The direction of the Moon between the steps of azel.dat. While the Moon that Boresight computes agrees with the file,
// the computed Moon is used, else the last step of the file. Computing the Moon needs the site. Directions, rises and
// sets are apparent, by the refraction of the target Moon (core/targets). The file has no refraction. Station thread
// only.
namespace boresight::sources {

class AzelMoon
{
public:
    // Call once in each tick, before the other functions. True: the site or the refraction has changed, so the Moon
    // rises and sets at other times.
    bool look(const ControlParts& view, const azel::AzelFeed& feed);

    // The angle between the Moon of the file and the computed Moon. Empty if one of them is missing.
    [[nodiscard]] const std::optional<Angle>& apart() const { return m_apart; }
    [[nodiscard]] bool interpolates() const;
    [[nodiscard]] bool differs() const;
    [[nodiscard]] bool isElsewhere() const;
    // Call only after the file has been read.
    [[nodiscard]] SkyPointing at(UtcTime utc);
    [[nodiscard]] SkyPointing step() const;  // the last one of the file
    // The angular rate across the sky. Empty while the steps of the file are used.
    [[nodiscard]] std::optional<AngularRate> skyRate(UtcTime utc);
    // The next moonrise or moonset. Empty if there is none within a day, or without a site.
    [[nodiscard]] std::optional<UtcTime> nextRise(UtcTime from);
    [[nodiscard]] std::optional<UtcTime> nextSet(UtcTime from);

private:
    void compare(const azel::AzelFeed& feed, bool isMoved);
    [[nodiscard]] std::optional<targets::UpTime> nextUp(UtcTime from);

    std::optional<ephemeris::Almanac> m_almanac;  // for m_apart
    std::optional<targets::TargetPath> m_path;
    std::optional<Site> m_site;  // for which both compute
    ephemeris::RefractionRule m_rule = ephemeris::RefractionRule::ByKind;
    SkyPointing m_step;    // the last step of the file, without refraction
    UtcTime m_compared{};  // the time in the file when m_apart was computed
    std::optional<Angle> m_apart;
};

}  // namespace boresight::sources

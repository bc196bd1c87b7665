// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/tables/table_path.h"
#include "core/targets/target.h"

#include <chrono>
#include <optional>
#include <variant>

// The direction of a target at one site at any time, and when it is up. It keeps data of the almanac for a minute, so
// it belongs to one thread.
//
// Directions are apparent, for pointing the beam. The rule ByKind applies no refraction to satellites, that of light to
// Sun, Moon and planets, and that of radio waves to radio sources. Another rule applies one refraction to all of them.
// Under every rule a satellite rises and sets by geometry. A position below the horizon is pointed to along the
// horizon: its bearing with elevation 0°. The long path has the opposite bearing and elevation 0°. No refraction is
// applied to a fixed direction or position, or to a table of directions. A table of positions is treated like a
// satellite. A table is up while its path is above the horizon without a gap.
namespace boresight::targets {

// From a rise, or from the requested time, to the set.
struct UpTime
{
    UtcTime rises;
    std::optional<UtcTime> sets = {};  // empty: not within a day

    bool operator==(const UpTime&) const = default;
};

// The apparent direction of a satellite under a rule.
[[nodiscard]] SkyPointing satelliteSeen(const SkyPointing& airless, ephemeris::RefractionRule rule);

class TargetPath
{
public:
    // How far ahead a rise and a set are searched.
    static constexpr std::chrono::hours kSearched{24};

    TargetPath(const Target& target, const Site& site,
               ephemeris::RefractionRule rule = ephemeris::RefractionRule::ByKind);

    [[nodiscard]] ephemeris::RefractionRule rule() const { return m_rule; }
    void setRule(ephemeris::RefractionRule rule) { m_rule = rule; }
    // The refraction that decides when the target rises and sets. All targets except Sun, Moon, planets and stars rise
    // by geometry.
    [[nodiscard]] ephemeris::Refraction refractionOfRise() const;

    // NotAvailable with the reason: the orbit or the table has ended, or the position is that of the site.
    [[nodiscard]] Result<SkyPointing> at(UtcTime utc);
    // The present or the next time above the horizon. A fixed direction or position is always up. Refused, with the
    // reason, if the target does not rise within kSearched, or if its orbit or its table has ended.
    [[nodiscard]] Result<UpTime> nextUp(UtcTime from);

private:
    using Fixed = Result<SkyPointing>;
    using Way = std::variant<orbit::Sgp4, ephemeris::SkyObject, Fixed, tables::TablePath>;

    [[nodiscard]] static Way wayOf(const Target& target, const orbit::Observer& observer);
    [[nodiscard]] Result<SkyPointing> satelliteAt(const orbit::Sgp4& orbit, UtcTime utc) const;
    [[nodiscard]] Result<UpTime> nextPass(const orbit::Sgp4& orbit, UtcTime from) const;
    [[nodiscard]] Result<UpTime> nextStay(const ephemeris::SkyObject& object, UtcTime from);
    [[nodiscard]] static Result<UpTime> nextStay(tables::TablePath& table, UtcTime from);
    [[nodiscard]] ephemeris::Refraction refractionOf(const ephemeris::SkyObject& object) const;
    [[nodiscard]] tl::unexpected<Error> neverUp() const;

    QString m_name;
    Site m_site;
    orbit::Observer m_observer;
    ephemeris::Almanac m_almanac;
    Way m_way;
    ephemeris::RefractionRule m_rule;
};

}  // namespace boresight::targets

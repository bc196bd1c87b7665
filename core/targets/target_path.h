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

// Where a target stands over one site at any time, and when it is up. It remembers what the almanac needs for a minute,
// so it belongs to one thread.
//
// Directions are those that the beam is pointed to. By kind, satellites are airless, Sun, Moon and planets appear where
// the air bends their light to, radio sources where it bends radio waves to. Another rule bends all of them alike. A
// position below the horizon is pointed to along it: its bearing, elevation 0°. The long path is the opposite bearing,
// elevation 0°. No rule bends what stays in its place. A satellite rises and sets by geometry under each rule. A table
// of positions is bent as a satellite, one of directions is not. It is up while it leads above the horizon without a
// gap.
namespace boresight::targets {

// From a rise, or from the time that was asked about, to the set.
struct UpTime
{
    UtcTime rises;
    std::optional<UtcTime> sets = {};  // empty: not within a day

    bool operator==(const UpTime&) const = default;
};

// By a rule, where a satellite appears whose direction is airless.
[[nodiscard]] SkyPointing satelliteSeen(const SkyPointing& airless, ephemeris::RefractionRule rule);

class TargetPath
{
public:
    // How far a rise and a set are looked for.
    static constexpr std::chrono::hours kSearched{24};

    TargetPath(const Target& target, const Site& site,
               ephemeris::RefractionRule rule = ephemeris::RefractionRule::ByKind);

    [[nodiscard]] ephemeris::RefractionRule rule() const { return m_rule; }
    void setRule(ephemeris::RefractionRule rule) { m_rule = rule; }

    // NotAvailable with the reason: the orbit or the table has ended, or the position is that of the site.
    [[nodiscard]] Result<SkyPointing> at(UtcTime utc);
    // The present stay above the horizon, or the next one. What stays in its place is always up. Refused with the
    // reason: it does not rise within kSearched, or its orbit or its table has ended.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target_path.h"

#include "core/base/overloaded.h"
#include "core/base/text.h"
#include "core/elements/julian_date.h"
#include "core/ephemeris/rise_set.h"
#include "core/passes/pass_finder.h"

#include <algorithm>

namespace boresight::targets {
namespace {

// The direction of a nearer position is meaningless.
constexpr double kNearest = 0.001;  // km

Result<SkyPointing> directionOf(const EarthPosition& position, const QString& name, const orbit::Observer& observer)
{
    const orbit::Vector ground = orbit::Observer(position.site).ground({}, 0.0);
    const orbit::LookAngles seen = observer.look({.position = ground, .velocity = {}});
    if (seen.kilometres < kNearest) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("%1 is the site of the mount, so it has no direction.").arg(name));
    }
    if (position.path == GreatCircle::Long) {
        return SkyPointing{.azimuth = (seen.direction.azimuth + 180_deg).wrapped360(), .elevation = {}};
    }
    return SkyPointing{.azimuth = seen.direction.azimuth, .elevation = std::max(seen.direction.elevation, 0_deg)};
}

}  // namespace

SkyPointing satelliteSeen(const SkyPointing& airless, ephemeris::RefractionRule rule)
{
    return ephemeris::apparent(airless, refractionBy(rule, ephemeris::Refraction::None));
}

TargetPath::TargetPath(const Target& target, const Site& site, ephemeris::RefractionRule rule)
    : m_name(target.name),
      m_site(site),
      m_observer(site),
      m_almanac(site),
      m_way(wayOf(target, m_observer)),
      m_rule(rule)
{}

TargetPath::Way TargetPath::wayOf(const Target& target, const orbit::Observer& observer)
{
    return std::visit(
        Overloaded{[](const orbit::ElementSet& elements) { return Way(orbit::Sgp4(elements)); },
                   [](const ephemeris::SkyObject& object) { return Way(object); },
                   [](const SkyPointing& direction) { return Way(Fixed(direction)); },
                   [&](const EarthPosition& position) { return Way(directionOf(position, target.name, observer)); },
                   [&](const tables::SharedTable& table) { return Way(tables::TablePath(table, observer)); }},
        target.kind);
}

Result<SkyPointing> TargetPath::at(UtcTime utc)
{
    return std::visit(
        Overloaded{[&](const orbit::Sgp4& orbit) { return satelliteAt(orbit, utc); },
                   [&](const ephemeris::SkyObject& object) {
                       return Fixed(ephemeris::apparent(see(m_almanac, object, utc).direction, refractionOf(object)));
                   },
                   [](const Fixed& direction) { return direction; },
                   [&](tables::TablePath& table) -> Result<SkyPointing> {
                       return table.at(utc).map([&](const tables::TablePlace& place) {
                           return place.kilometres ? satelliteSeen(place.direction, m_rule) : place.direction;
                       });
                   }},
        m_way);
}

Result<SkyPointing> TargetPath::satelliteAt(const orbit::Sgp4& orbit, UtcTime utc) const
{
    const orbit::JulianDate date = orbit::julianDate(utc);
    const orbit::OrbitResult state = orbit.propagate(date);
    if (!state) {
        return failure(ErrorCode::NotAvailable, orbit::describe(state.error()));
    }
    return satelliteSeen(m_observer.look(orbit::groundState(*state, date)).direction, m_rule);
}

Result<UpTime> TargetPath::nextUp(UtcTime from)
{
    return std::visit(Overloaded{[&](const orbit::Sgp4& orbit) { return nextPass(orbit, from); },
                                 [&](const ephemeris::SkyObject& object) { return nextStay(object, from); },
                                 [&](const Fixed& direction) {
                                     return direction.map([&](const SkyPointing&) { return UpTime{.rises = from}; });
                                 },
                                 [&](tables::TablePath& table) { return nextStay(table, from); }},
                      m_way);
}

ephemeris::Refraction TargetPath::refractionOf(const ephemeris::SkyObject& object) const
{
    return refractionBy(m_rule, std::holds_alternative<ephemeris::StarPlace>(object) ? ephemeris::Refraction::Radio
                                                                                     : ephemeris::Refraction::Light);
}

ephemeris::Refraction TargetPath::refractionOfRise() const
{
    const auto* const object = std::get_if<ephemeris::SkyObject>(&m_way);
    return object != nullptr ? refractionOf(*object) : ephemeris::Refraction::None;
}

tl::unexpected<Error> TargetPath::neverUp() const
{
    return failure(ErrorCode::Refused, Text::tr("%1 does not rise within a day.").arg(m_name));
}

Result<UpTime> TargetPath::nextPass(const orbit::Sgp4& orbit, UtcTime from) const
{
    const passes::PassList list =
        passes::findPasses(orbit, {.site = m_site, .from = from, .to = from + kSearched, .isClear = {}});
    if (list.passes.empty() && list.end) {
        return failure(
            ErrorCode::Refused,
            Text::tr("The orbit of %1 cannot be computed: %2").arg(m_name, orbit::describe(list.end->fault)));
    }
    if (list.passes.empty()) {
        return neverUp();
    }
    const passes::Pass& pass = list.passes.front();
    UpTime up{.rises = pass.aos.utc};
    if (!pass.isUpAtEnd) {
        up.sets = pass.los.utc;
    }
    return up;
}

// At the apparent horizon, with refraction.
Result<UpTime> TargetPath::nextStay(const ephemeris::SkyObject& object, UtcTime from)
{
    const Angle horizon = ephemeris::airless({}, refractionOf(object)).elevation;
    const bool isUp = see(m_almanac, object, from).direction.elevation > horizon;
    const auto rises = isUp ? std::optional(from) : ephemeris::nextRise(m_almanac, object, from, horizon);
    if (!rises || *rises - from > kSearched) {
        return neverUp();
    }
    return UpTime{.rises = *rises, .sets = ephemeris::nextSet(m_almanac, object, *rises, horizon)};
}

Result<UpTime> TargetPath::nextStay(tables::TablePath& table, UtcTime from)
{
    return table.nextStay(from, from + kSearched).map([](const tables::TableStay& stay) {
        return UpTime{.rises = stay.from, .sets = stay.to};
    });
}

}  // namespace boresight::targets

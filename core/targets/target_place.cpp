// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target_place.h"

#include "core/targets/track_rules.h"

#include <chrono>

namespace boresight::targets {
namespace {

// The next rise of a satellite may be found later. The clock may also have been set.
constexpr std::chrono::minutes kLookAgain{10};

}  // namespace

TargetPlace::TargetPlace(const Target& target, const Site& site, ephemeris::RefractionRule rule)
    : m_name(target.name), m_path(target, site, rule)
{}

void TargetPlace::setRule(ephemeris::RefractionRule rule)
{
    if (m_path.rule() != rule) {
        m_path.setRule(rule);
        m_lookedForAt = {};
    }
}

void TargetPlace::look(UtcTime now)
{
    const auto direction = m_path.at(now);
    m_direction = direction ? std::optional(*direction) : std::nullopt;
    const bool hasSet = m_up && m_up->sets && *m_up->sets <= now;
    if (hasSet || std::chrono::abs(now - m_lookedForAt) >= kLookAgain) {
        const auto up = m_path.nextUp(now);
        m_up = up ? std::optional(*up) : std::nullopt;
        m_isFound = up.map([](const UpTime&) {});
        m_lookedForAt = now;
    }
}

Result<> TargetPlace::isSoon(UtcTime now) const
{
    return m_up ? targets::isSoon(m_name, m_up->rises, now) : m_isFound;
}

}  // namespace boresight::targets

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_light.h"

#include "core/ephemeris/almanac.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/sunlight.h"
#include "core/orbit/topocentric.h"

#include <algorithm>
#include <chrono>

namespace boresight::passes {

namespace {

constexpr int kLooks = 120;
constexpr std::chrono::seconds kExact{1};

// Whether the Sun shines on one satellite over one site. The half shadow lasts some seconds and counts as shadow.
class Light
{
public:
    Light(const orbit::ElementSet& elements, const Site& site) : m_orbit(elements), m_observer(site), m_almanac(site) {}

    [[nodiscard]] bool isSunlit(UtcTime utc)
    {
        const orbit::JulianDate date = orbit::julianDate(utc);
        const auto state = m_orbit.propagate(date);
        return state && orbit::sunlight(orbit::groundState(*state, date).position,
                                        orbit::sunOverGround(m_almanac, m_observer, utc)) == orbit::Sunlight::Sunlit;
    }
    // The time of the change between two times, exactly one of which is in sunlight.
    [[nodiscard]] UtcTime change(UtcTime from, UtcTime to)
    {
        const bool before = isSunlit(from);
        while (to - from > kExact) {
            const UtcTime middle = from + (to - from) / 2;
            (isSunlit(middle) == before ? from : to) = middle;
        }
        return to;
    }

private:
    orbit::Sgp4 m_orbit;
    orbit::Observer m_observer;
    ephemeris::Almanac m_almanac;
};

}  // namespace

Seconds sunlitTime(const Pass& pass, const PassLight& light)
{
    Seconds sum{0.0};
    bool isSunlit = light.isSunlitFirst;
    UtcTime from = pass.aos.utc;
    const auto add = [&](UtcTime to) {
        sum += isSunlit ? Seconds(to - from) : Seconds(0.0);
        isSunlit = !isSunlit;
        from = to;
    };
    std::ranges::for_each(light.changes, add);
    add(pass.los.utc);
    return sum;
}

PassLight lightOf(const Pass& pass, const orbit::ElementSet& elements, const Site& site)
{
    Light light(elements, site);
    PassLight found{.isSunlitFirst = light.isSunlit(pass.aos.utc), .changes = {}};
    bool before = found.isSunlitFirst;
    UtcTime last = pass.aos.utc;
    for (int step = 1; step <= kLooks; ++step) {
        const UtcTime utc = pass.aos.utc + (pass.los.utc - pass.aos.utc) * step / kLooks;
        if (light.isSunlit(utc) != before) {
            found.changes.push_back(light.change(last, utc));
            before = !before;
        }
        last = utc;
    }
    return found;
}

}  // namespace boresight::passes

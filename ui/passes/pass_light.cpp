// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_light.h"

#include "core/ephemeris/almanac.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/sunlight.h"
#include "core/orbit/topocentric.h"
#include "ui/kit/format.h"
#include "ui/passes/pass_words.h"

#include <algorithm>
#include <chrono>

namespace boresight::ui {

namespace {

constexpr int kLooks = 120;
constexpr std::chrono::seconds kExact{1};

// Of one satellite over one site. The half shadow, some seconds long, counts as shadow.
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
    // Between two times, of which only one is in the light.
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

PassLight lightOf(const BookedPass& one, const PassBook& book)
{
    const passes::Pass& pass = one.pass;
    Light light(book.elementsOf(one), book.site);
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

// A pass of many hours may have more changes. The first two are shown.
QString lightText(const PassLight& light)
{
    const auto time = [&](std::size_t number) { return clockText(light.changes.at(number)); };
    switch (std::min<std::size_t>(light.changes.size(), 2)) {
        case 0:
            return light.isSunlitFirst ? PassWords::tr("in sunlight") : PassWords::tr("in the shadow of the Earth");
        case 1:
            return (light.isSunlitFirst ? PassWords::tr("enters the shadow %1Z")
                                        : PassWords::tr("leaves the shadow %1Z"))
                .arg(time(0));
        default:
            return (light.isSunlitFirst ? PassWords::tr("in the shadow %1Z to %2Z")
                                        : PassWords::tr("in sunlight %1Z to %2Z"))
                .arg(time(0), time(1));
    }
}

}  // namespace boresight::ui

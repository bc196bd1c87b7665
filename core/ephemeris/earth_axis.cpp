// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/earth_axis.h"

#include "core/ephemeris/time_scales.h"

#include <erfa.h>

#include <chrono>
#include <cmath>
#include <ratio>

namespace boresight::ephemeris {

// In five minutes the axis turns by less than 0.001″.
EarthAxis::Stand& EarthAxis::standAt(UtcTime utc)
{
    using Period = std::chrono::duration<std::int64_t, std::ratio<600>>;
    const auto period = std::chrono::floor<Period>(utc.time_since_epoch());
    if (!m_stand || m_stand->number != period.count()) {
        const TwoPartDate middle = terrestrialTime(UtcTime(period) + std::chrono::minutes(5));
        m_stand = Stand{.number = period.count()};
        eraPnm06a(middle.day, middle.fraction, m_stand->toDate);
        double x = 0.0;
        double y = 0.0;
        eraBpn2xy(m_stand->toDate, &x, &y);
        m_stand->origins = eraEors(m_stand->toDate, eraS06(middle.day, middle.fraction, x, y));
    }
    return *m_stand;
}

EarthAxis::Vector EarthAxis::ofTheEarth(const Vector& celestial, UtcTime utc)
{
    Vector given = celestial;
    Vector ofDate{};
    eraRxp(standAt(utc).toDate, given.data(), ofDate.data());
    return ofTheEarthFromDate(ofDate, utc);
}

EarthAxis::Vector EarthAxis::ofTheEarthFromDate(const Vector& ofDate, UtcTime utc)
{
    const TwoPartDate universal = universalDate(utc);
    const double turned = eraEra00(universal.day, universal.fraction) - standAt(utc).origins;
    return {std::cos(turned) * ofDate[0] + std::sin(turned) * ofDate[1],
            std::cos(turned) * ofDate[1] - std::sin(turned) * ofDate[0], ofDate[2]};
}

}  // namespace boresight::ephemeris

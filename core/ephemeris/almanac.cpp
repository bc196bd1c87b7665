// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/almanac.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace boresight::ephemeris {

namespace {

using Vector = std::array<double, 3>;

constexpr double kKilometresPerUnit = ERFA_DAU / 1000.0;
constexpr double kUnixEpoch = 2440587.5;  // Julian date of 1970-01-01 0h
constexpr double kMoonLightTime = 1.28 / ERFA_DAYSEC;
// Nominal radii of the IAU: resolution B3 of 2015; working group on cartographic coordinates, 2015.
constexpr double kSunRadius = 695700.0;
constexpr double kMoonRadius = 1737.4;

// In two parts: one double alone would resolve only 40 µs.
struct JulianDate
{
    double day = 0.0;
    double fraction = 0.0;
};

JulianDate julianDate(UtcTime utc)
{
    const auto day = std::chrono::floor<std::chrono::days>(utc);
    return {kUnixEpoch + static_cast<double>(day.time_since_epoch().count()), Seconds(utc - day).count() / ERFA_DAYSEC};
}

// ERFA knows the leap seconds, the last one of 2016-12-31; its doubt about dates far ahead is ours as well.
JulianDate terrestrialTime(const JulianDate& utc)
{
    JulianDate atomic;
    JulianDate terrestrial;
    (void)eraUtctai(utc.day, utc.fraction, &atomic.day, &atomic.fraction);
    (void)eraTaitt(atomic.day, atomic.fraction, &terrestrial.day, &terrestrial.fraction);
    return terrestrial;
}

double product(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector scaled(const double (&vector)[3], double factor)
{
    return {factor * vector[0], factor * vector[1], factor * vector[2]};
}

constexpr double kKilometresPerSecond = kKilometresPerUnit / ERFA_DAYSEC;  // of an astronomical unit per day

// The Sun hardly moves while its light travels, so aberration by the Earth's own motion is all there is.
BodyMotion sun(const JulianDate& terrestrial)
{
    double fromSun[2][3];
    double fromBarycentre[2][3];
    (void)eraEpv00(terrestrial.day, terrestrial.fraction, fromSun, fromBarycentre);
    double distance = 0.0;
    double away[3];
    eraPn(fromSun[0], &distance, away);
    double towards[3];
    eraSxp(-1.0, away, towards);
    double velocity[3];  // of light
    eraSxp(1.0 / ERFA_DC, fromBarycentre[1], velocity);
    double seen[3];
    eraAb(towards, velocity, distance, std::sqrt(1.0 - eraPdp(velocity, velocity)), seen);
    return {scaled(seen, distance * kKilometresPerUnit), scaled(fromSun[1], -kKilometresPerSecond)};
}

// Its aberration is its light time: both move around the Sun together.
BodyMotion moon(const JulianDate& terrestrial)
{
    double state[2][3];
    eraMoon98(terrestrial.day, terrestrial.fraction - kMoonLightTime, state);
    return {scaled(state[0], kKilometresPerUnit), scaled(state[1], kKilometresPerSecond)};
}

UtcTime middleOf(std::int64_t minute)
{
    return UtcTime(std::chrono::minutes(minute) + std::chrono::seconds(30));
}

}  // namespace

Almanac::Almanac(const Site& site)
{
    const double latitude = site.latitude.radians();
    const double longitude = site.longitude.radians();
    double metres[3] = {};
    (void)eraGd2gc(ERFA_WGS84, longitude, latitude, site.heightMetres, metres);
    m_site = scaled(metres, 0.001);
    const double sinLatitude = std::sin(latitude);
    const double cosLatitude = std::cos(latitude);
    const double sinLongitude = std::sin(longitude);
    const double cosLongitude = std::cos(longitude);
    m_ground = {{{-sinLongitude, cosLongitude, 0.0},
                 {-sinLatitude * cosLongitude, -sinLatitude * sinLongitude, cosLatitude},
                 {cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude}}};
}

// The Earth's axis turns by less than 0.0002″ in half a minute. What bends the way of a body in that time is less.
Almanac::Minute& Almanac::minuteOf(UtcTime utc)
{
    const std::int64_t number = std::chrono::floor<std::chrono::minutes>(utc).time_since_epoch().count();
    if (!m_minute || m_minute->number != number) {
        const JulianDate middle = terrestrialTime(julianDate(middleOf(number)));
        m_minute = Minute{.number = number};
        eraPnm06a(middle.day, middle.fraction, m_minute->toDate);
        double x = 0.0;
        double y = 0.0;
        eraBpn2xy(m_minute->toDate, &x, &y);
        m_minute->origins = eraEors(m_minute->toDate, eraS06(middle.day, middle.fraction, x, y));
    }
    return *m_minute;
}

Almanac::Vector Almanac::celestial(Body body, UtcTime utc)
{
    Minute& minute = minuteOf(utc);
    const UtcTime middle = middleOf(minute.number);
    std::optional<BodyMotion>& motion = minute.bodies[static_cast<std::size_t>(body)];
    if (!motion) {
        const JulianDate terrestrial = terrestrialTime(julianDate(middle));
        motion = body == Body::Sun ? sun(terrestrial) : moon(terrestrial);
    }
    const double since = Seconds(utc - middle).count();
    return {motion->place[0] + since * motion->rate[0], motion->place[1] + since * motion->rate[1],
            motion->place[2] + since * motion->rate[2]};
}

// UT1 is taken as UTC, which is never wrong by more than 0.9 s; the pole as standing still.
BodyPlace Almanac::place(Body body, UtcTime utc)
{
    Vector fromEarth = celestial(body, utc);
    Minute& minute = minuteOf(utc);
    const JulianDate universal = julianDate(utc);
    const double turned = eraEra00(universal.day, universal.fraction) - minute.origins;
    double ofDate[3];
    eraRxp(minute.toDate, fromEarth.data(), ofDate);
    const Vector seen = {std::cos(turned) * ofDate[0] + std::sin(turned) * ofDate[1] - m_site[0],
                         std::cos(turned) * ofDate[1] - std::sin(turned) * ofDate[0] - m_site[1],
                         ofDate[2] - m_site[2]};
    const double east = product(m_ground[0], seen);
    const double north = product(m_ground[1], seen);
    const double up = product(m_ground[2], seen);
    const double distance = std::hypot(east, north, up);
    const double size = body == Body::Sun ? kSunRadius : kMoonRadius;
    return {.direction = {.azimuth = Angle::fromRadians(std::atan2(east, north)).wrapped360(),
                          .elevation = Angle::fromRadians(std::atan2(up, std::hypot(east, north)))},
            .kilometres = distance,
            .radius = Angle::fromRadians(std::asin(size / distance))};
}

}  // namespace boresight::ephemeris

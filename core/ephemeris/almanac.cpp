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

// From the Earth's centre, kilometres, celestial frame. The Sun hardly moves while its light travels, so aberration by
// the Earth's own motion is all there is.
Vector sun(const JulianDate& terrestrial)
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
    return scaled(seen, distance * kKilometresPerUnit);
}

// Its aberration is its light time: both move around the Sun together.
Vector moon(const JulianDate& terrestrial)
{
    double state[2][3];
    eraMoon98(terrestrial.day, terrestrial.fraction - kMoonLightTime, state);
    return scaled(state[0], kKilometresPerUnit);
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

// It turns by less than 0.0002″ in half a minute, and costs as much to reckon as all the rest.
void Almanac::followEarthAxis(UtcTime utc)
{
    const auto minute = std::chrono::floor<std::chrono::minutes>(utc);
    const std::int64_t number = minute.time_since_epoch().count();
    if (!m_earthAxis || m_earthAxis->minute != number) {
        const JulianDate middle = terrestrialTime(julianDate(minute + std::chrono::seconds(30)));
        m_earthAxis = EarthAxis{.minute = number};
        eraPnm06a(middle.day, middle.fraction, m_earthAxis->toDate);
    }
}

// UT1 is taken as UTC, which is never wrong by more than 0.9 s; the pole as standing still.
BodyPlace Almanac::place(Body body, UtcTime utc)
{
    const JulianDate universal = julianDate(utc);
    const JulianDate terrestrial = terrestrialTime(universal);
    followEarthAxis(utc);
    const double turned =
        eraGst06(universal.day, universal.fraction, terrestrial.day, terrestrial.fraction, m_earthAxis->toDate);
    Vector celestial = body == Body::Sun ? sun(terrestrial) : moon(terrestrial);
    double ofDate[3];
    eraRxp(m_earthAxis->toDate, celestial.data(), ofDate);
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

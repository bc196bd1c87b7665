// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/almanac.h"

#include "core/ephemeris/time_scales.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>

namespace boresight::ephemeris {

namespace {

using Vector = std::array<double, 3>;

constexpr double kKilometresPerUnit = ERFA_DAU / 1000.0;
constexpr double kMoonLightTime = 1.28 / ERFA_DAYSEC;
// Nominal radii in km: IAU resolution B3 of 2015, and the IAU working group on cartographic coordinates, 2015.
constexpr double kSunRadius = 695700.0;
constexpr double kMoonRadius = 1737.4;
constexpr std::array kPlanetRadii{2440.5, 6051.8, 3396.2, 71492.0, 60268.0, 25559.0, 24764.0};  // at the equator

double product(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector scaled(const double (&vector)[3], double factor)
{
    return {factor * vector[0], factor * vector[1], factor * vector[2]};
}

constexpr double kKilometresPerSecond = kKilometresPerUnit / ERFA_DAYSEC;  // in one astronomical unit per day

struct Earth
{
    double fromSun[2][3];         // position and velocity in astronomical units and days
    double fromBarycentre[2][3];  // of the planets and the Sun
};

Earth earthAt(const TwoPartDate& terrestrial)
{
    Earth earth;
    (void)eraEpv00(terrestrial.day, terrestrial.fraction, earth.fromSun, earth.fromBarycentre);
    return earth;
}

// The direction of the unit vector `towards` as a moving observer sees it. `velocity` is in units of the speed of
// light. `fromSun` is the distance of the observer from the Sun in astronomical units.
Vector aberrated(const double (&towards)[3], const Vector& velocity, double fromSun)
{
    double given[3] = {towards[0], towards[1], towards[2]};
    double moving[3] = {velocity[0], velocity[1], velocity[2]};
    double seen[3];
    eraAb(given, moving, fromSun, std::sqrt(1.0 - eraPdp(moving, moving)), seen);
    return {seen[0], seen[1], seen[2]};
}

// The Sun hardly moves while its light travels. So only the aberration by the motion of the Earth is applied.
BodyMotion sun(const TwoPartDate& terrestrial)
{
    Earth earth = earthAt(terrestrial);
    double distance = 0.0;
    double away[3];
    eraPn(earth.fromSun[0], &distance, away);
    double towards[3];
    eraSxp(-1.0, away, towards);
    const Vector seen = aberrated(towards, scaled(earth.fromBarycentre[1], 1.0 / ERFA_DC), distance);
    const double kilometres = distance * kKilometresPerUnit;
    return {{kilometres * seen[0], kilometres * seen[1], kilometres * seen[2]},
            scaled(earth.fromSun[1], -kKilometresPerSecond)};
}

// ERFA's number of the planet. 3 is the Earth with the Moon.
int numberOf(Planet planet)
{
    const int index = static_cast<int>(planet);
    return index < 2 ? index + 1 : index + 2;
}

// The position at the time when the light left the planet, with the aberration by the motion of the Earth.
BodyMotion planetMotion(Planet planet, const TwoPartDate& terrestrial)
{
    Earth earth = earthAt(terrestrial);
    double fromEarth[2][3];
    double lightDays = 0.0;
    for (int round = 0; round < 3; ++round) {  // the third round changes the position of Mercury by less than 0.0001″
        double fromSun[2][3];
        (void)eraPlan94(terrestrial.day, terrestrial.fraction - lightDays, numberOf(planet), fromSun);
        eraPvmpv(fromSun, earth.fromSun, fromEarth);
        lightDays = eraPm(fromEarth[0]) / ERFA_DC;
    }
    double distance = 0.0;
    double towards[3];
    eraPn(fromEarth[0], &distance, towards);
    const Vector seen = aberrated(towards, scaled(earth.fromBarycentre[1], 1.0 / ERFA_DC), eraPm(earth.fromSun[0]));
    const double kilometres = distance * kKilometresPerUnit;
    return {{kilometres * seen[0], kilometres * seen[1], kilometres * seen[2]},
            scaled(fromEarth[1], kKilometresPerSecond)};
}

// The light time is all of the Moon's aberration, because the Moon moves around the Sun together with the Earth.
BodyMotion moon(const TwoPartDate& terrestrial)
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

// Within half a minute, the curvature of a body's path causes an error below 0.001″.
Almanac::Minute& Almanac::minuteOf(UtcTime utc)
{
    const std::int64_t number = std::chrono::floor<std::chrono::minutes>(utc).time_since_epoch().count();
    if (!m_minute || m_minute->number != number) {
        m_minute = Minute{.number = number};
    }
    return *m_minute;
}

SkyPointing Almanac::directionOf(const Vector& fromSite) const
{
    const double east = product(m_ground[0], fromSite);
    const double north = product(m_ground[1], fromSite);
    const double up = product(m_ground[2], fromSite);
    return {.azimuth = Angle::fromRadians(std::atan2(east, north)).wrapped360(),
            .elevation = Angle::fromRadians(std::atan2(up, std::hypot(east, north)))};
}

BodyPlace Almanac::placeOf(const BodyMotion& motion, double radius, UtcTime utc)
{
    const double since = Seconds(utc - middleOf(minuteOf(utc).number)).count();
    Vector seen = m_axis.ofTheEarth({motion.place[0] + since * motion.rate[0], motion.place[1] + since * motion.rate[1],
                                     motion.place[2] + since * motion.rate[2]},
                                    utc);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seen[i] -= m_site[i];
    }
    const double distance = std::hypot(seen[0], seen[1], seen[2]);
    return {.direction = directionOf(seen),
            .kilometres = distance,
            .radius = Angle::fromRadians(std::asin(radius / distance))};
}

BodyPlace Almanac::place(Body body, UtcTime utc)
{
    Minute& minute = minuteOf(utc);
    std::optional<BodyMotion>& motion = minute.bodies[static_cast<std::size_t>(body)];
    if (!motion) {
        const TwoPartDate middle = terrestrialTime(middleOf(minute.number));
        motion = body == Body::Sun ? sun(middle) : moon(middle);
    }
    return placeOf(*motion, body == Body::Sun ? kSunRadius : kMoonRadius, utc);
}

BodyPlace Almanac::place(Planet planet, UtcTime utc)
{
    Minute& minute = minuteOf(utc);
    const auto index = static_cast<std::size_t>(planet);
    std::optional<BodyMotion>& motion = minute.planets[index];
    if (!motion) {
        motion = planetMotion(planet, terrestrialTime(middleOf(minute.number)));
    }
    return placeOf(*motion, kPlanetRadii[index], utc);
}

SkyPointing Almanac::direction(const StarPlace& star, UtcTime utc)
{
    Minute& minute = minuteOf(utc);
    if (!minute.earthVelocity) {
        const Earth earth = earthAt(terrestrialTime(middleOf(minute.number)));
        minute.earthVelocity = scaled(earth.fromBarycentre[1], 1.0 / ERFA_DC);
    }
    double towards[3];
    eraS2c(star.rightAscension.radians(), star.declination.radians(), towards);
    return directionOf(m_axis.ofTheEarth(aberrated(towards, *minute.earthVelocity, 1.0), utc));
}

}  // namespace boresight::ephemeris

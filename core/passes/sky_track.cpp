// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/sky_track.h"

#include "core/orbit/sidereal_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace boresight::passes {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSecondsPerDay = 86400.0;
constexpr double kGravity = 398600.8;  // km³/s², WGS-72
// The elevation of a low orbit has one maximum per revolution. A sixtieth is small enough for elongated ellipses, too.
constexpr double kSampleArc = 2.0 * kPi / 60.0;
constexpr double kLongestStep = 600.0;  // s: the Earth turns by 2.5°
// Margins for changes within one revolution that the osculating ellipse does not include: oblateness, drag, Sun and
// Moon.
constexpr double kReachMargin = 1.01;
constexpr double kHurryMargin = 1.03;

// The rate of the sidereal time, which is the rotation of the Earth in TEME.
double rotationFrom(const orbit::JulianDate& start)
{
    const double turned = orbit::siderealTime({start.day + 1.0, start.fraction}) - orbit::siderealTime(start);
    return (2.0 * kPi + turned - 2.0 * kPi * std::floor(turned / (2.0 * kPi))) / kSecondsPerDay;
}

// The vertical of the site. Computed from a far point, so that the position of the site costs no digits.
orbit::Vector verticalOf(const orbit::Observer& observer, const orbit::Vector& site)
{
    constexpr double kFar = 1e6;
    return (1.0 / kFar) * (observer.ground({.elevation = 90_deg}, kFar) - site);
}

}  // namespace

bool mayBeUpBetween(const SkyMoment& a, const SkyMoment& b)
{
    const double hurry = std::max(a.hurry, b.hurry);
    return 0.5 * (a.apart + b.apart - hurry * (b.seconds - a.seconds)) < std::max(a.reach, b.reach);
}

SkyTrack::SkyTrack(const orbit::Sgp4& orbit, const PassSearch& search)
    : m_orbit(orbit),
      m_observer(search.site),
      m_start(search.from),
      m_startMinutes(orbit::minutesBetween(orbit.epoch(), orbit::julianDate(search.from))),
      m_startAngle(orbit::siderealTime(orbit::julianDate(search.from))),
      m_rotation(rotationFrom(orbit::julianDate(search.from))),
      m_sineLimit(std::sin(search.minimumElevation.radians())),
      m_site(m_observer.ground({}, 0.0)),
      m_up(verticalOf(m_observer, m_site)),
      m_siteHeight(dot(m_site, m_up)),
      m_siteRadius(length(m_site)),
      m_siteTurn(m_rotation * std::hypot(m_up.x, m_up.y))
{}

std::optional<SkyMoment> SkyTrack::at(double seconds)
{
    ++m_propagations;
    const orbit::OrbitResult state = m_orbit.propagate(m_startMinutes + seconds / 60.0, m_resonance);
    if (!state) {
        if (seconds < m_faultSeconds) {
            m_faultSeconds = seconds;
            m_fault = state.error();
        }
        return std::nullopt;
    }
    // The angle of the Earth is continued from that of the start. Computed from the date of each moment it would be
    // exact to only 1e-7 s, which is visible in the highest moment of a geostationary satellite.
    const double angle = m_startAngle + m_rotation * seconds;
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    const auto turned = [&](const orbit::Vector& v) {
        return orbit::Vector{c * v.x + s * v.y, c * v.y - s * v.x, v.z};
    };
    SkyMoment moment{.seconds = seconds, .ground = turned(state->position)};
    const orbit::Vector carried{-m_rotation * moment.ground.y, m_rotation * moment.ground.x, 0.0};
    const orbit::Vector velocity = turned(state->velocity) - carried;
    const orbit::Vector seen = moment.ground - m_site;
    const double up = dot(seen, m_up);
    const double upRate = dot(velocity, m_up);
    const double range = std::max(orbit::length(seen), 1e-6);
    const double along = dot(seen, velocity);
    const double rangeRate = along / range;
    moment.sineElevation = up / range;
    moment.above = up - m_sineLimit * range;
    moment.aboveRate = upRate - m_sineLimit * rangeRate;
    moment.climb = upRate * range * range - up * along;
    moment.swing = std::sqrt(std::max(0.0, dot(velocity, velocity) - rangeRate * rangeRate)) / range;
    addReach(*state, moment);
    return moment;
}

// Computes the bounds from the osculating ellipse of this moment. A satellite that is up is above the horizontal plane
// of the site, or above the cone of the minimum elevation. The smallest distance gives the bound for the cone.
void SkyTrack::addReach(const orbit::OrbitState& state, SkyMoment& moment) const
{
    const double radius = orbit::length(state.position);
    const double along = dot(state.position, state.velocity);
    const double square = dot(state.velocity, state.velocity);
    const double axis = 1.0 / (2.0 / radius - square / kGravity);
    const double eCosine = 1.0 - radius / axis;
    const double eSine = along / std::sqrt(kGravity * axis);
    const double eccentricity = std::sqrt(eCosine * eCosine + eSine * eSine);
    moment.apart = std::acos(std::clamp(dot(moment.ground, m_up) / radius, -1.0, 1.0));
    if (!(axis > 0.0 && eccentricity < 0.995)) {  // hardly an orbit: use small steps
        moment.reach = kPi;
        moment.hurry = 1.0;
        moment.motion = 1e-3;
        moment.step = 10.0;
        return;
    }
    const double perigee = axis * (1.0 - eccentricity);
    const double apogee = axis * (1.0 + eccentricity) * kReachMargin;
    const double distance =
        m_sineLimit < 0.0 ? apogee + m_siteRadius : std::max(0.0, perigee / kReachMargin - m_siteRadius);
    moment.reach = std::acos(std::clamp((m_siteHeight + m_sineLimit * distance) / apogee, -1.0, 1.0));
    const double momentum = std::sqrt(std::max(0.0, radius * radius * square - along * along));
    moment.hurry = kHurryMargin * momentum / (perigee * perigee) + m_siteTurn;
    moment.motion = std::sqrt(kGravity / axis) / axis;
    // Equal steps of the eccentric anomaly, which is close enough to the true anomaly at the perigee (Kepler's
    // equation).
    const double arc = kSampleArc * std::sqrt((1.0 - eccentricity) / (1.0 + eccentricity));
    const double mean = arc * (1.0 - eCosine + arc * (0.5 * eSine + arc * eCosine / 6.0));
    moment.step = std::clamp(mean / moment.motion, 1.0, kLongestStep);
}

UtcTime SkyTrack::utc(double seconds) const
{
    return m_start + std::chrono::round<UtcTime::duration>(Seconds(seconds));
}

SkyPointing SkyTrack::direction(const SkyMoment& moment) const
{
    return m_observer.look({.position = moment.ground}).direction;
}

PassMoment SkyTrack::passMoment(const SkyMoment& moment) const
{
    return {.utc = utc(moment.seconds), .direction = direction(moment)};
}

}  // namespace boresight::passes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_check.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr Seconds kKept{25.0};  // the longest latency and average that a profile allows, plus jitter
// A sentence may be this early or late because of the loop of the sensor.
constexpr Seconds kJitter{0.3};
constexpr int kSensorCheckFewest = 2;  // number of values that must differ, or agree again
// Agrees again clearly below the threshold, so that the alarm does not flicker.
constexpr double kAgreesBelow = 0.7;
constexpr Angle kMoved = Angle::fromDegrees(1.0);

SteadyTime earlier(SteadyTime time, Seconds by)
{
    return time - std::chrono::duration_cast<SteadyTime::duration>(by);
}

}  // namespace

void SensorCheck::note(SteadyTime now, const std::optional<SkyPointing>& axes)
{
    if (!axes) {
        m_places.clear();
        return;
    }
    const Angle azimuth = m_places.empty() ? axes->azimuth : axes->azimuth.nearestTo(m_places.back().azimuth);
    m_places.push_back({now, azimuth, axes->elevation});
    while (now - m_places.front().time > kKept) {
        m_places.pop_front();
    }
}

void SensorCheck::take(const SensorDirection& reading)
{
    const auto azimuths = azimuthsOf(reading.arrival);
    const auto elevations = passed(&Place::elevation, reading.arrival, Seconds(0.0));
    Case& azimuth = m_cases[index(Axis::Azimuth)];
    Case& elevation = m_cases[index(Axis::Elevation)];
    // Without an elevation axis only the sensor knows the elevation of the antenna.
    const Angle height = m_missing == Axis::Elevation ? reading.direction.elevation
                         : elevations                 ? elevations->mean
                                                      : 90_deg;
    if (azimuths && abs(height) < kHighestForCompass && reading.azimuthCounts && m_missing != Axis::Azimuth) {
        const Angle difference = (reading.direction.azimuth - azimuths->mean).wrapped180();
        // The difference as an angle on the sky, which is smaller than that in azimuth near the zenith.
        const double shrink = std::cos(height.radians());
        judge(azimuth, difference, (abs(difference) - azimuths->spread()) * shrink, reading.arrival);
    } else {
        azimuth = {};
    }
    if (elevations && reading.elevationCounts && m_missing != Axis::Elevation) {
        const Angle difference = reading.direction.elevation - elevations->mean;
        judge(elevation, difference, abs(difference) - elevations->spread(), reading.arrival);
    } else {
        elevation = {};
    }
}

void SensorCheck::judge(Case& which, const std::optional<Angle>& difference, Angle excess, SteadyTime arrival)
{
    which.difference.now = difference;
    which.difference.beyond = excess > m_settings.threshold;
    if (which.difference.beyond) {
        if (which.differing++ == 0) {
            which.since = arrival;
            which.difference.beganMoving = which.difference.beganMoving || moves(earlier(arrival, Seconds(2.0)));
        }
        which.agreeing = 0;
        return;
    }
    if (!which.difference.lasts ||
        (excess < m_settings.threshold * kAgreesBelow && ++which.agreeing >= kSensorCheckFewest)) {
        which = Case{.difference = {.now = difference}};
    }
}

void SensorCheck::tick(SteadyTime now)
{
    for (Case& one : m_cases) {
        const bool lasting = one.differing >= kSensorCheckFewest && one.since && now - *one.since >= m_settings.time;
        one.difference.lasts = one.difference.lasts || lasting;
    }
}

void SensorCheck::forget()
{
    m_cases = {};
}

std::optional<SensorCheck::Passed> SensorCheck::azimuthsOf(SteadyTime arrival) const
{
    return passed(&Place::azimuth, earlier(arrival, m_settings.latency), m_settings.averaging);
}

std::optional<SensorCheck::Passed> SensorCheck::passed(Angle Place::*angle, SteadyTime middle, Seconds width) const
{
    const SteadyTime from = earlier(middle, width / 2.0 + kJitter);
    const SteadyTime to = earlier(middle, -(width / 2.0 + kJitter));
    if (m_places.empty() || m_places.front().time > from) {
        return std::nullopt;
    }
    const auto first = std::ranges::lower_bound(m_places, from, {}, &Place::time);
    const auto last = std::ranges::upper_bound(m_places, to, {}, &Place::time);
    if (first == last) {
        return std::nullopt;
    }
    const auto [least, most] =
        std::minmax_element(first, last, [angle](const Place& a, const Place& b) { return a.*angle < b.*angle; });
    Angle sum;
    for (auto place = first; place != last; ++place) {
        sum += (*place).*angle - (*least).*angle;
    }
    const Angle mean = (*least).*angle + sum / static_cast<double>(last - first);
    return Passed{.least = (*least).*angle, .mean = mean, .most = (*most).*angle};
}

bool SensorCheck::moves(SteadyTime since) const
{
    const auto first = std::ranges::lower_bound(m_places, since, {}, &Place::time);
    return first != m_places.end() && (abs(m_places.back().azimuth - first->azimuth) > kMoved ||
                                       abs(m_places.back().elevation - first->elevation) > kMoved);
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/scan_run.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

// Time to move from one place to the next and for the receiver to settle.
constexpr SteadyTime::duration kRest = std::chrono::seconds(4);
// Time for the receiver to settle after a longer way.
constexpr SteadyTime::duration kSettling = std::chrono::milliseconds(1500);
constexpr Seconds kListening{1.0};
constexpr Seconds kScanRunPatience{120.0};
// The first way starts wherever the mount stood: up to one full turn on a slow mount.
constexpr Seconds kLongestWay{600.0};

}  // namespace

ScanRun::ScanRun(Angle width, SteadyTime now) : m_places(placesOf(width)), m_came(now), m_moved(now) {}

std::vector<calibration::SkyOffset> ScanRun::placesOf(Angle width)
{
    std::vector<calibration::SkyOffset> places;
    for (int place = 0; place < 2 * kPlaces; ++place) {
        const Angle offset = width * (static_cast<double>(place % kPlaces) / (kPlaces - 1) - 0.5);
        places.push_back(place < kPlaces ? calibration::SkyOffset{.across = offset, .elevation = {}}
                                         : calibration::SkyOffset{.across = {}, .elevation = offset});
    }
    return places;
}

calibration::SkyOffset ScanRun::offset() const
{
    if (comesBack()) {
        return {};
    }
    calibration::SkyOffset place = m_places[static_cast<std::size_t>(m_place)];
    place.across += m_place < kPlaces ? Angle{} : m_turned;
    return place;
}

SteadyTime ScanRun::settled() const
{
    return std::max(m_came + kRest, m_moved + kSettling);
}

void ScanRun::moves(SteadyTime now)
{
    m_moved = now;
    m_heard.clear();
}

void ScanRun::hear(double decibels, SteadyTime arrival)
{
    if (comesBack() || arrival < settled()) {
        return;
    }
    if (m_heard.empty()) {
        m_firstHeard = arrival;
    }
    m_heard.push_back(decibels);
}

std::optional<double> ScanRun::heard(SteadyTime now) const
{
    if (m_heard.empty() || Seconds(now - m_firstHeard) < kListening) {
        return std::nullopt;
    }
    std::vector<double> powers = m_heard;
    const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::nth_element(powers.begin(), middle, powers.end());
    return *middle;
}

QString ScanRun::obstacle(SteadyTime now) const
{
    if (!m_noPeak.isEmpty()) {
        return m_noPeak;  // without a peak in the first line the second line would be of no use
    }
    if (rests(now)) {
        return Seconds(now - settled()) > kScanRunPatience ? Text::tr("No power reading received.") : QString();
    }
    return Seconds(now - m_came) > kLongestWay ? Text::tr("The mount does not stand still.") : QString();
}

void ScanRun::give(double decibels, SteadyTime now)
{
    const bool across = m_place < kPlaces;
    const calibration::SkyOffset place = offset();
    (across ? m_across : m_elevation)
        .push_back({.offset = across ? place.across : place.elevation, .decibels = decibels});
    ++m_place;
    m_came = now;
    m_heard.clear();
    if (m_place == kPlaces) {
        turnAtPeak();
    }
}

void ScanRun::turnAtPeak()
{
    if (const auto peak = calibration::fitScan(m_across)) {
        m_turned = peak->offset.value;
    } else {
        m_noPeak = Text::tr("across: %1").arg(peak.error().text);
    }
}

QString ScanRun::text(SteadyTime now) const
{
    if (comesBack()) {
        return Text::tr("back to the middle");
    }
    const QString place = Text::tr("place %1 of %2").arg(m_place + 1).arg(2 * kPlaces);
    return wantsPower(now) ? Text::tr("%1: waits for the power").arg(place) : place;
}

Result<calibration::CrossScan> ScanRun::outcome(const AxisPosition& middle) const
{
    return calibration::fitCrossScan(middle, m_across, m_elevation, m_turned);
}

}  // namespace boresight

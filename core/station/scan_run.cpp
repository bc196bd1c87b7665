// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/scan_run.h"

#include "core/base/text.h"

namespace boresight {
namespace {

// From one place to the next, or from the end of a line to its middle, and for the receiver to settle.
constexpr Seconds kRest{4.0};
constexpr Seconds kPatience{120.0};

}  // namespace

ScanRun::ScanRun(Angle width, SteadyTime now) : m_width(width), m_came(now) {}

calibration::SkyOffset ScanRun::offset() const
{
    if (comesBack()) {
        return {};
    }
    const int inLine = m_place % kPlaces;
    const Angle offset = m_width * (static_cast<double>(inLine) / (kPlaces - 1) - 0.5);
    return m_place < kPlaces ? calibration::SkyOffset{.across = offset, .elevation = {}}
                             : calibration::SkyOffset{.across = {}, .elevation = offset};
}

bool ScanRun::rests(SteadyTime now) const
{
    return Seconds(now - m_came) >= kRest;
}

bool ScanRun::late(SteadyTime now) const
{
    return Seconds(now - m_came) > kPatience;
}

void ScanRun::give(double decibels, SteadyTime now)
{
    const bool across = m_place < kPlaces;
    const calibration::SkyOffset place = offset();
    (across ? m_across : m_elevation)
        .push_back({.offset = across ? place.across : place.elevation, .decibels = decibels});
    ++m_place;
    m_came = now;
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
    return calibration::fitCrossScan(middle, m_across, m_elevation);
}

}  // namespace boresight

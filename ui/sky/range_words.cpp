// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/range_words.h"

#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <optional>

namespace boresight::ui {

namespace {

struct RangeWords
{
    Q_DECLARE_TR_FUNCTIONS(RangeWords)
};

constexpr double kHzPerMegahertz = 1e6;

QString withSign(double value, int decimals)
{
    return (value < 0.0 ? QString() : QStringLiteral("+")) + QString::number(value, 'f', decimals);
}

// Empty if it is below the horizon or its orbit cannot be computed.
std::optional<orbit::LookAngles> lookAt(const orbit::ElementSet& elements, const Site& site, UtcTime utc)
{
    const orbit::JulianDate date = orbit::julianDate(std::chrono::floor<std::chrono::seconds>(utc));
    const orbit::OrbitResult state = orbit::Sgp4(elements).propagate(date);
    if (!state) {
        return std::nullopt;
    }
    const orbit::LookAngles seen = orbit::Observer(site).look(orbit::groundState(*state, date));
    if (seen.direction.elevation < 0_deg) {
        return std::nullopt;
    }
    return seen;
}

QString rangeOf(const orbit::LookAngles& seen)
{
    return RangeWords::tr("%1 km, %2 km/s").arg(seen.kilometres, 0, 'f', 0).arg(withSign(seen.kilometresPerSecond, 2));
}

QString shiftOf(const orbit::LookAngles& seen)
{
    return RangeWords::tr("%1 Hz/MHz").arg(withSign((seen.dopplerFactor() - 1.0) * kHzPerMegahertz, 1));
}

}  // namespace

QString rangeText(const orbit::ElementSet& elements, const Site& site, UtcTime utc)
{
    const auto seen = lookAt(elements, site, utc);
    return seen ? RangeWords::tr("%1, Doppler %2").arg(rangeOf(*seen), shiftOf(*seen)) : QString();
}

QString trackedRangeText(const StationStatus& status)
{
    if (!status.tracked || !status.tracked->number || !status.profile->site.known) {
        return {};
    }
    const std::int64_t number = *status.tracked->number;
    const auto found = std::ranges::lower_bound(*status.satellites, number, {}, &orbit::ElementSet::number);
    if (found == status.satellites->end() || found->number != number) {
        return {};
    }
    const auto seen = lookAt(*found, status.profile->site.place(), status.utc);
    return seen ? RangeWords::tr("%1, %2").arg(rangeOf(*seen), shiftOf(*seen)) : QString();
}

}  // namespace boresight::ui

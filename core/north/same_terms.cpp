// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/same_terms.h"

#include <algorithm>

namespace boresight {
namespace {

// A profile stores arcs with this resolution.
constexpr Angle kSameArc = Angle::fromDegrees(0.051);

bool isSame(const calibration::UnreliableSector& a, const calibration::UnreliableSector& b)
{
    return abs(a.from - b.from) <= kSameArc && abs(a.to - b.to) <= kSameArc;
}

bool isSame(const calibration::DeviationCurve& a, const calibration::DeviationCurve& b)
{
    const auto same = [](Angle x, Angle y) { return abs(x - y) <= kSameTerm; };
    return same(a.a1, b.a1) && same(a.b1, b.b1) && same(a.a2, b.a2) && same(a.b2, b.b2) &&
           std::ranges::equal(a.unreliable, b.unreliable, [](const auto& x, const auto& y) { return isSame(x, y); });
}

}  // namespace

bool isSame(const pointing::PointingTerms& a, const pointing::PointingTerms& b, Angle tolerance)
{
    return std::ranges::all_of(calibration::kAllTerms, [&](calibration::Term term) {
        return abs(calibration::valueOf(a, term) - calibration::valueOf(b, term)) <= tolerance;
    });
}

bool isSame(const calibration::SensorMounting& a, const calibration::SensorMounting& b)
{
    return a.sense == b.sense && abs((a.azimuthOffset - b.azimuthOffset).wrapped180()) <= kSameTerm &&
           abs(a.elevationOffset - b.elevationOffset) <= kSameTerm &&
           isSame(a.curve.value_or(calibration::DeviationCurve{}), b.curve.value_or(calibration::DeviationCurve{}));
}

pointing::PointingTerms changedOnly(pointing::PointingTerms entered, const pointing::PointingTerms& present)
{
    for (const calibration::Term term : calibration::kAllTerms) {
        const Angle now = calibration::valueOf(present, term);
        if (abs(calibration::valueOf(entered, term) - now) <= kSameTerm) {
            calibration::valueOf(entered, term) = now;
        }
    }
    return entered;
}

}  // namespace boresight

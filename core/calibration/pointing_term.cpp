// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/pointing_term.h"

#include <algorithm>

namespace boresight::calibration {
namespace {

using pointing::PointingTerms;

constexpr std::array<Angle PointingTerms::*, kTerms> kMembers = {
    &PointingTerms::azimuthOffset, &PointingTerms::elevationOffset, &PointingTerms::tiltNorth,
    &PointingTerms::tiltEast,      &PointingTerms::collimation,     &PointingTerms::nonPerpendicularity,
    &PointingTerms::elevationSag};

constexpr std::array<std::string_view, kTerms> kNames = {"azimuth_offset", "elevation_offset", "tilt_north",
                                                         "tilt_east",      "collimation",      "non_perpendicularity",
                                                         "elevation_sag"};

}  // namespace

Angle& valueOf(PointingTerms& terms, Term term)
{
    return terms.*kMembers[indexOf(term)];
}

Angle valueOf(const PointingTerms& terms, Term term)
{
    return terms.*kMembers[indexOf(term)];
}

std::string_view nameOf(Term term)
{
    return kNames[indexOf(term)];
}

std::optional<Term> termOfName(std::string_view name)
{
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    return found == kNames.end() ? std::nullopt
                                 : std::optional(kAllTerms[static_cast<std::size_t>(found - kNames.begin())]);
}

TermKnowledge TermKnowledge::usual()
{
    TermKnowledge known;
    known.of(Term::ElevationOffset) = {Angle{}, Angle::fromDegrees(3.0)};
    known.of(Term::TiltNorth) = {Angle{}, Angle::fromDegrees(1.0)};
    known.of(Term::TiltEast) = {Angle{}, Angle::fromDegrees(1.0)};
    known.of(Term::Collimation) = {Angle{}, Angle::fromDegrees(0.3)};
    known.of(Term::NonPerpendicularity) = {Angle{}, Angle::fromDegrees(0.1)};
    known.of(Term::ElevationSag) = {Angle{}, Angle::fromDegrees(0.1)};
    return known;
}

}  // namespace boresight::calibration

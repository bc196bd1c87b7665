// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/estimate.h"
#include "core/pointing/pointing_model.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

// The terms of the pointing model as a list, and what is known of each before any point was taken. Pure.
namespace boresight::calibration {

enum class Term
{
    AzimuthOffset,
    ElevationOffset,
    TiltNorth,
    TiltEast,
    Collimation,
    NonPerpendicularity,
    ElevationSag
};

inline constexpr std::size_t kTerms = 7;
inline constexpr std::array<Term, kTerms> kAllTerms = {
    Term::AzimuthOffset, Term::ElevationOffset,     Term::TiltNorth,   Term::TiltEast,
    Term::Collimation,   Term::NonPerpendicularity, Term::ElevationSag};

[[nodiscard]] constexpr std::size_t indexOf(Term term)
{
    return static_cast<std::size_t>(term);
}

[[nodiscard]] Angle& valueOf(pointing::PointingTerms& terms, Term term);
[[nodiscard]] Angle valueOf(const pointing::PointingTerms& terms, Term term);

// The name in a profile and in exchanged files: "azimuth_offset".
[[nodiscard]] std::string_view nameOf(Term term);
[[nodiscard]] std::optional<Term> termOfName(std::string_view name);

// The knowledge about a term before any point was taken. The azimuth offset may be unknown.
struct TermKnowledge
{
    std::array<std::optional<Estimate>, kTerms> terms;

    [[nodiscard]] const std::optional<Estimate>& of(Term term) const { return terms[indexOf(term)]; }
    [[nodiscard]] std::optional<Estimate>& of(Term term) { return terms[indexOf(term)]; }

    // Usual errors (one sigma) of a mount that was set up with a spirit level and a tape measure: zero of elevation 3°,
    // tilt 1°, beam 0.3° off its axis, boom flexure 0.1°, axes perpendicular to 0.1°.
    [[nodiscard]] static TermKnowledge usual();
};

}  // namespace boresight::calibration

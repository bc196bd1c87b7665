// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/estimate.h"
#include "core/pointing/pointing_model.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

// The terms of the pointing model, to be counted through, and what is known of each before any point was taken. Pure.
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

// As in a profile and in exchanged files: "azimuth_offset".
[[nodiscard]] std::string_view nameOf(Term term);
[[nodiscard]] std::optional<Term> termOfName(std::string_view name);

// Before a point was taken. Of the azimuth's offset nothing need be known.
struct TermKnowledge
{
    std::array<std::optional<Estimate>, kTerms> terms;

    [[nodiscard]] const std::optional<Estimate>& of(Term term) const { return terms[indexOf(term)]; }
    [[nodiscard]] std::optional<Estimate>& of(Term term) { return terms[indexOf(term)]; }

    // What is usual on a mount that was set up with a spirit level and a tape: a zero of elevation within 3°, a tilt
    // within 1°, a beam 0.3° off its axis, a boom that hangs by 0.1°, axes that cross squarely to 0.1°; one sigma
    // each.
    [[nodiscard]] static TermKnowledge usual();
};

}  // namespace boresight::calibration

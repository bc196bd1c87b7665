// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

// The coefficients of the World Magnetic Model in the form of its published file (WMM.COF): for each term of the
// spherical harmonics up to degree 12 the value at the epoch and its change per year. Pure values.
namespace boresight::geomagnetism {

inline constexpr int kDegree = 12;

struct Term
{
    double g = 0.0;  // nT, or nT per year
    double h = 0.0;

    bool operator==(const Term&) const = default;
};

// The terms n = 0…12, m = 0…n. The model has no term n = 0, so that one stays empty.
using Terms = std::array<Term, (kDegree + 1) * (kDegree + 2) / 2>;

[[nodiscard]] constexpr std::size_t termIndex(int n, int m)
{
    return static_cast<std::size_t>(n * (n + 1) / 2 + m);
}

struct Coefficients
{
    std::string name;    // "WMM-2025"
    double epoch = 0.0;  // decimal year
    Terms main;
    Terms change;

    bool operator==(const Coefficients&) const = default;
};

// A header "EPOCH NAME DATE", a line "n m g h g' h'" for each term with m running fastest, then lines of nines. Any
// other text is refused with the number of the line.
[[nodiscard]] Result<Coefficients> parseCoefficients(std::string_view text);

}  // namespace boresight::geomagnetism

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"

#include <map>
#include <string>
#include <utility>

// Coefficient files made for the tests: all terms are zero except the given ones.
namespace boresight::geomagnetism {

struct SyntheticTerm
{
    Term main;
    Term change;
};

using SyntheticTerms = std::map<std::pair<int, int>, SyntheticTerm>;  // by n, m

[[nodiscard]] std::string coefficientText(const SyntheticTerms& terms, const std::string& header);

}  // namespace boresight::geomagnetism

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/geomagnetism/synthetic_model.h"

#include "core/base/numbers.h"

namespace boresight::geomagnetism {

std::string coefficientText(const SyntheticTerms& terms, const std::string& header)
{
    std::string text = header + "\n";
    for (int n = 1; n <= kDegree; ++n) {
        for (int m = 0; m <= n; ++m) {
            const auto found = terms.find({n, m});
            const SyntheticTerm term = found != terms.end() ? found->second : SyntheticTerm{};
            text += std::to_string(n) + " " + std::to_string(m);
            for (const double value : {term.main.g, term.main.h, term.change.g, term.change.h}) {
                text += "  " + formatFixed(value, 1);
            }
            text += "\n";
        }
    }
    const std::string nines(48, '9');
    return text + nines + "\n" + nines + "\n";
}

}  // namespace boresight::geomagnetism

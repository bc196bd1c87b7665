// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

// Published files that are not ours to hand on: they lie beside the checkout, or in the folder that the environment
// variable BORESIGHT_REFERENCE_DATA names.
namespace boresight::fakes {

[[nodiscard]] std::string referencePath(const std::string& name);
[[nodiscard]] bool hasReference(const std::string& name);
[[nodiscard]] std::string referenceText(const std::string& name);
// Without comments that begin with "#". Each is cut at the commas.
[[nodiscard]] std::vector<std::vector<std::string>> referenceRows(const std::string& name);

}  // namespace boresight::fakes

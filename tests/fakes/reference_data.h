// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

// Reference files. Those that we may not redistribute lie beside the checkout, or in the folder named by the
// environment variable BORESIGHT_REFERENCE_DATA. Our own tables are also in tests/data, and are read from there if the
// folder does not have them.
namespace boresight::fakes {

[[nodiscard]] std::string referencePath(const std::string& name);
[[nodiscard]] bool hasReference(const std::string& name);
[[nodiscard]] std::string referenceText(const std::string& name);
// The rows without comments that begin with "#", each split at the commas.
[[nodiscard]] std::vector<std::vector<std::string>> referenceRows(const std::string& name);

}  // namespace boresight::fakes

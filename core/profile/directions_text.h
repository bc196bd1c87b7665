// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <string>

// Changes one setting inside the text of a profile file. Comments and order of the file stay as the operator wrote
// them. Pure.
namespace boresight::profile {

// The file's text with `directions = "confirmed"` and nothing else changed. Refuses a file that does not read without
// error, one of the simulated mount, and one in which the place of the key cannot be found.
[[nodiscard]] Result<std::string> withDirectionsConfirmed(const std::string& toml, const QString& fileName);

}  // namespace boresight::profile

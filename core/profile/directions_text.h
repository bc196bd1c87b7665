// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <string>

// Changes one setting inside the text of a profile file. Comments and order of the file stay as the operator wrote
// them. Pure.
namespace boresight::profile {

// Returns the text with `directions = "confirmed"` and without any other change. Refuses a text with errors, the
// profile of the simulated mount, and a text in which the place of the key was not found.
[[nodiscard]] Result<std::string> withDirectionsConfirmed(const std::string& toml, const QString& fileName);

}  // namespace boresight::profile

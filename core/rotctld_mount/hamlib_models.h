// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_models.h"

#include <QString>

#include <vector>

// The models that Hamlib drives, as `rotctl -l` lists them.
namespace boresight::rotctl {

// Its columns are those of the line that names them. Other lines are left out.
[[nodiscard]] std::vector<RotatorModel> parseModels(const QString& listing);
// Runs rotctl. Waits for it: not on a thread that has anything else to do.
[[nodiscard]] RotatorModels hamlibModels();
// What to install.
[[nodiscard]] QString hamlibIsMissing();

}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_models.h"

#include <QString>

#include <vector>

// The rotator models of Hamlib, as `rotctl -l` lists them.
namespace boresight::rotctl {

// The header line of the list defines the columns. Lines that are no models are left out.
[[nodiscard]] std::vector<RotatorModel> parseModels(const QString& listing);
// Runs rotctl and waits for it. Use a thread that has nothing else to do.
[[nodiscard]] RotatorModels hamlibModels();
// The advice what to install.
[[nodiscard]] QString hamlibIsMissing();

}  // namespace boresight::rotctl

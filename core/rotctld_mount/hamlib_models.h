// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_models.h"

#include <QString>

#include <chrono>
#include <vector>

// The rotator models of Hamlib, as `rotctl -l` lists them.
namespace boresight::rotctl {

// The header line of the list defines the columns. Lines that are no models are left out.
[[nodiscard]] std::vector<RotatorModel> parseModels(const QString& listing);
// Runs rotctl and waits for it, which takes 50 ms, and seconds on a busy computer. Use a thread.
[[nodiscard]] RotatorModels hamlibModels(std::chrono::seconds patience = std::chrono::seconds(10));
// The advice what to install.
[[nodiscard]] QString hamlibIsMissing();

}  // namespace boresight::rotctl

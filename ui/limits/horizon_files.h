// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "ui/link/profile_draft.h"

// Imports and exports the horizon of the draft as text files of other programs ("az el", core/profile/horizon_text.h).
namespace boresight::ui {

// Returns a text about the import for the operator. A file that cannot be read changes nothing, and the reasons name
// each line.
[[nodiscard]] Result<QString> importHorizon(ProfileDraft& draft, const QString& path);
[[nodiscard]] Result<> exportHorizon(const ProfileDraft& draft, const QString& path);

}  // namespace boresight::ui

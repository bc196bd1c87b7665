// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "ui/link/profile_draft.h"

// The horizon of the draft from and to the text files of other programs ("az el", core/profile/horizon_text.h).
namespace boresight::ui {

// What was taken, for the operator. A file that cannot be read changes nothing; the reasons name each line.
[[nodiscard]] Result<QString> importHorizon(ProfileDraft& draft, const QString& path);
[[nodiscard]] Result<> exportHorizon(const ProfileDraft& draft, const QString& path);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

// Keeps the file of a profile and its previous version: FILE and FILE~. With FILE~ the last change can be undone, and
// an undo can be undone, too. Blocking file access: not on the gui thread and not on the station thread.
namespace boresight::profile {

// Does not write a file whose text would not change, because then FILE~ would be the same and undo would do nothing.
[[nodiscard]] Result<> saveKeepingPrevious(const Profile& profile, const QString& path);

[[nodiscard]] bool hasPrevious(const QString& path);
// Exchanges the two versions. Returns the profile that FILE then contains.
[[nodiscard]] Result<Profile> undoLastChange(const QString& path);

// Returns FILE~ for FILE.
[[nodiscard]] QString previousOf(const QString& path);

}  // namespace boresight::profile

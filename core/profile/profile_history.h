// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

// A profile's file with the version before it: FILE and FILE~. That is what the last change can be undone with, and an
// undone change can be undone again. Blocking file access: not on the gui thread, nor the station's.
namespace boresight::profile {

// What the file already says in the same words is not written again: it would leave nothing to undo.
[[nodiscard]] Result<> saveKeepingPrevious(const Profile& profile, const QString& path);

[[nodiscard]] bool hasPrevious(const QString& path);
// Exchanges the two versions; the profile that the file then holds.
[[nodiscard]] Result<Profile> undoLastChange(const QString& path);

// Of FILE: FILE~.
[[nodiscard]] QString previousOf(const QString& path);

}  // namespace boresight::profile

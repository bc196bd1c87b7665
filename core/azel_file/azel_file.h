// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/profile/profile.h"

#include <QString>

// The file azel.dat, where it is. Blocking: not on the gui thread, nor the station's.
namespace boresight::azel {

// As the profile says, else where WSJT-X writes it for this user. It need not exist.
[[nodiscard]] QString azelPath(const profile::AzelSettings& settings);

// Opened for reading only, and closed at once. Of a file that is too long no more is read than shows that.
[[nodiscard]] AzelReading readAzelFile(const QString& path);

}  // namespace boresight::azel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/profile/profile.h"

#include <QString>

// Finds and reads the file azel.dat. Blocking: neither on the gui thread nor on the station thread.
namespace boresight::azel {

// The path in the profile, or else where WSJT-X writes the file for this user. The file may be missing.
[[nodiscard]] QString azelPath(const profile::AzelSettings& settings);

// Opens the file for reading and closes it at once. Reads only as much of a too long file as is needed to detect that.
[[nodiscard]] AzelReading readAzelFile(const QString& path);

}  // namespace boresight::azel

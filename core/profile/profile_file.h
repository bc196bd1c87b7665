// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

#include <string>
#include <string_view>

// The profile as a TOML file. Reading is strict: an unknown key, a wrong type or a value out of range is an error. All
// errors of a file are reported together, one "FILE:LINE: KEY: reason" per line of the text. A missing key has its
// default. File access blocks, so it happens at the start and when the operator saves, not during a motion.
namespace boresight::profile {

[[nodiscard]] Result<Profile> parseProfile(std::string_view toml, const QString& fileName);
[[nodiscard]] Result<Profile> loadProfile(const QString& path);

// A warning if the file contains a password and every user of this computer can read it. Else empty.
[[nodiscard]] QString exposedSecret(const Profile& profile, const QString& path);

// The whole profile with a comment above every key: text, unit, range, default.
[[nodiscard]] std::string toToml(const Profile& profile);
// All or nothing: after a failure the old file is unchanged. A profile that could not be read again is not written.
[[nodiscard]] Result<> saveProfile(const Profile& profile, const QString& path);

}  // namespace boresight::profile

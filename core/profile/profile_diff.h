// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "core/profile/setting.h"

#include <span>
#include <string>
#include <vector>

// Compares two profiles and combines them, key by key. The keys are those of settings(). Each list ("limits.horizon",
// "keep_out", "preset") and the site ("site") count as one key, because their parts are useful only together. Two
// values with the same text in the file are equal. Pure.
namespace boresight::profile {

struct Change
{
    std::string key;
    QString before;  // for people: "450.0 °", "12 points", "not given"
    QString after;
    Applies applies = Applies::Now;

    bool operator==(const Change&) const = default;
};

// The changes, in the order of the file.
[[nodiscard]] std::vector<Change> changesBetween(const Profile& from, const Profile& to);
[[nodiscard]] std::vector<std::string> changedKeys(const Profile& from, const Profile& to);

// Copies the settings with these keys from `from` to `into`. Unknown keys are ignored.
void takeOver(Profile& into, const Profile& from, std::span<const std::string> keys);

// The result of applying a wanted profile while the mount is connected.
struct Application
{
    Profile inForce;                       // the wanted profile, but with the old values of the waiting keys
    std::vector<std::string> waitingKeys;  // settings that wait for Reconnect

    bool operator==(const Application&) const = default;
};

// Settings that apply on reconnect wait. Settings that are valid only together with them wait, too, such as a park
// position in a new travel.
[[nodiscard]] Application applied(const Profile& inForce, const Profile& wanted);

}  // namespace boresight::profile

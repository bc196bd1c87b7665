// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "core/profile/setting.h"

#include <span>
#include <string>
#include <vector>

// Two profiles compared and joined key by key. The keys are those of settings(), but a list ("limits.horizon",
// "keep_out", "preset") and the site ("site") count as one each: their parts mean something only together. Two values
// that are written alike are the same. Pure.
namespace boresight::profile {

struct Change
{
    std::string key;
    QString before;  // for people: "450.0 °", "12 points", "not given"
    QString after;
    Applies applies = Applies::Now;

    bool operator==(const Change&) const = default;
};

// In the order of the file.
[[nodiscard]] std::vector<Change> changesBetween(const Profile& from, const Profile& to);
[[nodiscard]] std::vector<std::string> changedKeys(const Profile& from, const Profile& to);

// `into` takes these over from `from`; other keys than the above are passed over.
void takeOver(Profile& into, const Profile& from, std::span<const std::string> keys);

// What becomes of a wanted profile while the mount works.
struct Application
{
    Profile inForce;                       // the wanted one, with what waits as it was
    std::vector<std::string> waitingKeys;  // for the reconnect

    bool operator==(const Application&) const = default;
};

// What applies on reconnect waits, and what makes sense only together with it (a park place in a new travel) waits too.
[[nodiscard]] Application applied(const Profile& inForce, const Profile& wanted);

}  // namespace boresight::profile

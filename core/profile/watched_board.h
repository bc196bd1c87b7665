// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <string>
#include <string_view>

// A board on the bus that turns no axis of the mount and is only read: "3 polarisation". Pure.
namespace boresight::profile {

struct WatchedBoard
{
    int id = 0;
    std::string name;

    bool operator==(const WatchedBoard&) const = default;
};

// Fails with InvalidInput if the id is not from 1 to 126 or the name is missing.
[[nodiscard]] Result<WatchedBoard> parseWatchedBoard(std::string_view text);
// True if the profile names the board with this id.
[[nodiscard]] bool watches(const Profile& profile, int id);

}  // namespace boresight::profile

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <string>
#include <string_view>

// The boards on the bus that turn neither azimuth nor elevation: those that are only read ("3 polarisation"), and the
// board of the third axis. Pure.
namespace boresight::profile {

struct WatchedBoard
{
    int id = 0;
    std::string name;

    bool operator==(const WatchedBoard&) const = default;
};

// Fails with InvalidInput if the id is not from 1 to 126 or the name is missing.
[[nodiscard]] Result<WatchedBoard> parseWatchedBoard(std::string_view text);
// True if the profile names the board with this id as one to watch.
[[nodiscard]] bool watches(const Profile& profile, int id);
// The same, or it is the board of the third axis.
[[nodiscard]] bool isFurtherBoard(const Profile& profile, int id);

}  // namespace boresight::profile

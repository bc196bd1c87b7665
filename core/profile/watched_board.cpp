// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/watched_board.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>

namespace boresight::profile {
namespace {

constexpr std::int64_t kHighestId = 126;

}  // namespace

Result<WatchedBoard> parseWatchedBoard(std::string_view text)
{
    const auto space = text.find(' ');
    const auto id = parseInteger(text.substr(0, space));
    const std::string_view name = space == std::string_view::npos ? std::string_view() : text.substr(space + 1);
    if (!id || *id < 1 || *id > kHighestId || name.find_first_not_of(' ') == std::string_view::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the id of a board and its name are expected, like \"3 polarisation\""));
    }
    return WatchedBoard{.id = static_cast<int>(*id), .name = std::string(name)};
}

bool watches(const Profile& profile, int id)
{
    return std::ranges::any_of(profile.watchedBoards, [id](const std::string& text) {
        const auto board = parseWatchedBoard(text);
        return board && board->id == id;
    });
}

}  // namespace boresight::profile

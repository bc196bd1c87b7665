// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/setting.h"

#include <string>
#include <vector>

namespace boresight::profile {

inline std::vector<std::string> keysOf(const std::vector<Problem>& problems)
{
    std::vector<std::string> keys;
    for (const Problem& problem : problems) {
        keys.push_back(problem.key);
    }
    return keys;
}

}  // namespace boresight::profile

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace boresight {

// ASCII letters in upper case, whatever the locale of the process is. All other bytes stay.
[[nodiscard]] constexpr char upper(char one)
{
    return one >= 'a' && one <= 'z' ? static_cast<char>(one - 'a' + 'A') : one;
}

[[nodiscard]] inline std::string upper(std::string_view text)
{
    std::string whole(text);
    std::ranges::transform(whole, whole.begin(), [](char one) { return upper(one); });
    return whole;
}

}  // namespace boresight

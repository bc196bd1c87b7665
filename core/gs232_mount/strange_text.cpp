// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/strange_text.h"

#include "core/base/control_characters.h"

#include <algorithm>

namespace boresight::gs232 {

std::string shownOfStrange(std::string_view bytes)
{
    constexpr std::size_t kShown = 24;  // bytes
    std::string text = printable(std::string(bytes.substr(0, kShown)));
    std::ranges::replace_if(
        text, [](char one) { return static_cast<unsigned char>(one) >= 0x80; }, '?');
    return text;
}

}  // namespace boresight::gs232

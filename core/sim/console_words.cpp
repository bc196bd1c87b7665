// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/sim/console_commands.h"

#include <algorithm>

namespace boresight::sim::console {

std::string refusal(std::string_view why)
{
    return "ERR " + std::string(why) + "\r\n";
}

// Removes the first word from `text` and returns it.
std::string_view takeWord(std::string_view& text)
{
    const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    return word;
}

std::optional<double> takeNumber(std::string_view& text)
{
    const std::string_view word = takeWord(text);
    return word == "nan" ? kNone : parseFinite(word);
}

std::string lengthBytes(std::size_t size)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i, size >>= 8) {
        bytes.push_back(static_cast<char>(size & 0xff));
    }
    return bytes;
}

}  // namespace boresight::sim::console

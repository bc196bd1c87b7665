// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <string>
#include <string_view>

// The ASCII control characters, line ends and DEL among them: no part of a name, and TOML has no place for them either.
// They do harm in a log line or on a terminal.
namespace boresight {

[[nodiscard]] constexpr bool isControlCharacter(char character)
{
    return (character >= '\0' && character < ' ') || character == '\x7f';
}

[[nodiscard]] constexpr bool hasControlCharacters(std::string_view text)
{
    return std::ranges::any_of(text, isControlCharacter);
}

// For the log and the screen: each of them as '?'.
[[nodiscard]] inline std::string printable(std::string text)
{
    std::ranges::replace_if(text, isControlCharacter, '?');
    return text;
}

[[nodiscard]] inline QString printable(QString text)
{
    const auto isControl = [](QChar one) { return one.unicode() < 0x80 && isControlCharacter(one.toLatin1()); };
    std::replace_if(text.begin(), text.end(), isControl, QChar(u'?'));
    return text;
}

}  // namespace boresight

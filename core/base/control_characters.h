// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <algorithm>
#include <string>
#include <string_view>

// The ASCII control characters, including line ends and DEL. They are not permitted in names or in TOML, and can spoil
// a log line or a terminal.
namespace boresight {

[[nodiscard]] constexpr bool isControlCharacter(char character)
{
    return (character >= '\0' && character < ' ') || character == '\x7f';
}

[[nodiscard]] constexpr bool hasControlCharacters(std::string_view text)
{
    return std::ranges::any_of(text, isControlCharacter);
}

// For the log and the screen: replaces each control character by '?'.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

// The lines of a text, numbered from 1, without line ends (LF, CR LF), trailing blanks and byte order mark. Pure.
namespace boresight::orbit {

class TextLines
{
public:
    explicit TextLines(std::string_view text);

    // Goes to the next line. False at the end of the text. Call it before the first line() too.
    [[nodiscard]] bool next();
    [[nodiscard]] std::string_view line() const { return m_line; }
    [[nodiscard]] int number() const { return m_number; }

private:
    std::string_view m_rest;
    std::string_view m_line;
    int m_number = 0;
};

}  // namespace boresight::orbit

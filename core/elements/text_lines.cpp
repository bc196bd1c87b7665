// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/text_lines.h"

#include <algorithm>

namespace boresight::orbit {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\n";

}  // namespace

TextLines::TextLines(std::string_view text)
    : m_rest(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text)
{}

bool TextLines::next()
{
    if (m_rest.empty()) {
        return false;
    }
    const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
    m_line = m_rest.substr(0, end);
    m_line = m_line.substr(0, m_line.find_last_not_of(kBlanks) + 1);
    m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
    ++m_number;
    return true;
}

}  // namespace boresight::orbit

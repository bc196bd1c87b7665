// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

// The bytes of one command of a stream, as they were received, for the protocol log. The line ends before the command
// belong to the command before. Pure.
namespace boresight::rotctld {

class ReceivedLine
{
public:
    static constexpr std::size_t kMostKept = 1024;

    void add(std::string_view bytes)
    {
        if (m_skips) {
            const std::size_t end = bytes.find('\n');
            m_skips = end == std::string_view::npos;
            bytes.remove_prefix(std::min(end, bytes.size()));
        }
        if (m_size == 0) {
            bytes.remove_prefix(std::min(bytes.find_first_not_of("\r\n"), bytes.size()));
        }
        m_size += bytes.size();
        m_bytes.append(bytes.substr(0, kMostKept - std::min(m_bytes.size(), kMostKept)));
    }
    // The rest of the line is ignored: `rest` is the part of it that has arrived, and more may follow.
    void addIgnored(std::string_view rest)
    {
        if (!m_bytes.ends_with('\n')) {
            add(rest.substr(0, rest.find('\n')));
            m_skips = true;
        }
    }
    // The next line begins.
    void end()
    {
        m_bytes.clear();
        m_size = 0;
    }
    // While nobody keeps lines.
    void forget()
    {
        end();
        m_skips = false;
    }

    [[nodiscard]] std::string_view bytes() const { return m_bytes; }  // at most kMostKept
    [[nodiscard]] std::size_t size() const { return m_size; }         // of all bytes

private:
    std::string m_bytes;
    std::size_t m_size = 0;
    bool m_skips = false;  // up to the next line feed
};

}  // namespace boresight::rotctld

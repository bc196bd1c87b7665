// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

// Cuts a byte stream into lines, however the bytes are split on their way. LF, CR and CR LF end a line. Empty lines are
// skipped. A line that is too long is dropped up to its end and counted. Holds at most one line.
namespace boresight {

class LineSplitter
{
public:
    // The limit of the fdcanusb for one line, without its end.
    static constexpr std::size_t kLongestLine = 300;

    // Calls `onLine` for each complete line. The view is valid only during the call.
    void add(std::string_view bytes, const std::function<void(std::string_view)>& onLine);
    // Drops half a line. After a reopen it belongs to nothing.
    void clear();
    [[nodiscard]] std::uint64_t overlongLines() const { return m_overlongLines; }

private:
    std::string m_line;
    bool m_overlong = false;
    std::uint64_t m_overlongLines = 0;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/line_splitter.h"

#include <utility>

namespace boresight {

void LineSplitter::add(std::string_view bytes, const std::function<void(std::string_view)>& onLine)
{
    for (const char character : bytes) {
        const bool lineEnd = character == '\n' || character == '\r';
        if (!lineEnd && m_line.size() < kLongestLine) {
            m_line += character;
            continue;
        }
        if (!lineEnd) {
            m_overlong = true;
            continue;
        }
        // Moved out first, because onLine may close the port and clear() this splitter.
        const std::string line = std::exchange(m_line, {});
        if (std::exchange(m_overlong, false)) {
            ++m_overlongLines;
        } else if (!line.empty()) {
            onLine(line);
        }
    }
}

void LineSplitter::clear()
{
    m_line.clear();
    m_overlong = false;
}

}  // namespace boresight

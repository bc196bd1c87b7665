// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace boresight {

// The sources and headers below a folder of the project, each as "core/sim/servo.h".
inline std::vector<std::string> sourcesBelow(const std::string& top)
{
    const std::filesystem::path root(BORESIGHT_SOURCES);
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") {
            found.push_back(entry.path().lexically_relative(root).string());
        }
    }
    return found;
}

// Whether the character at this place, if there is one, is a letter, a digit or an underscore.
inline bool isPartOfAWord(const std::string& line, std::size_t at)
{
    return at < line.size() && (std::isalnum(static_cast<unsigned char>(line[at])) != 0 || line[at] == '_');
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/records/file_problems.h"

#include "core/base/control_characters.h"

#include <algorithm>

namespace boresight::records {

void FileProblems::add(std::size_t line, const std::string& problem)
{
    m_problems.push_back({line, printable(problem)});
}

std::string FileProblems::text(const std::string& fileName) const
{
    std::vector<Problem> sorted = m_problems;
    std::ranges::stable_sort(sorted, {}, &Problem::line);
    std::string all;
    for (const Problem& problem : sorted) {
        all += (all.empty() ? "" : "\n") + fileName + ":" + std::to_string(problem.line) + ": " + problem.text;
    }
    return all;
}

}  // namespace boresight::records

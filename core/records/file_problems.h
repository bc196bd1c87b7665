// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>
#include <vector>

// Everything that is wrong with one file, to be reported at once. Pure.
namespace boresight::records {

class FileProblems
{
public:
    // "KEY: REASON" of a line, counted from 1. Control characters of the file become '?'.
    void add(std::size_t line, const QString& problem);

    [[nodiscard]] std::size_t count() const { return m_problems.size(); }
    // One "FILE:LINE: KEY: REASON" per line, in the order of lines.
    [[nodiscard]] QString text(const QString& fileName) const;

private:
    struct Problem
    {
        std::size_t line;
        QString text;
    };

    std::vector<Problem> m_problems;
};

}  // namespace boresight::records

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>
#include <vector>

// Collects all errors of one file, so that they can be reported together. Pure.
namespace boresight::records {

class FileProblems
{
public:
    // Adds "KEY: REASON" for a line, counted from 1. Control characters from the file become '?'.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>

#include <cstddef>
#include <utility>
#include <vector>

// The result of the readers of element sets: the good sets in the order of the text, and why the others are left out.
// Pure value.
namespace boresight::orbit {

struct ElementProblem
{
    int line = 0;  // from 1
    QString reason;

    bool operator==(const ElementProblem&) const = default;
};

struct ElementList
{
    // A file of another kind has a problem in each line. At most this many are kept, the others are only counted.
    static constexpr std::size_t kMostProblems = 1000;
    // A file with this many further problems contains no element sets.
    static constexpr std::size_t kMostFurtherProblems = 100'000;

    std::vector<ElementSet> sets;
    std::vector<ElementProblem> problems;
    std::size_t furtherProblems = 0;

    // The readers stop when this is true.
    [[nodiscard]] bool isHopeless() const { return furtherProblems >= kMostFurtherProblems; }

    void addProblem(int line, QString reason)
    {
        if (problems.size() < kMostProblems) {
            problems.push_back({line, std::move(reason)});
        } else {
            ++furtherProblems;
        }
    }
};

}  // namespace boresight::orbit

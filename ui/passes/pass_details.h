// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/cable_turns.h"
#include "ui/passes/pass_book.h"

#include <memory>
#include <unordered_map>

// What takes some milliseconds to work out of a pass: only of the passes that are seen, and once. Gui thread.
namespace boresight::ui {

// Whether the mount tracks it in one go.
[[nodiscard]] targets::CableTurns cableOf(const BookedPass& one, const PassBook& book);

class PassDetails
{
public:
    void begin(const std::shared_ptr<const PassBook>& book);

    // By the number of the pass in the book.
    [[nodiscard]] Seconds sunlit(std::size_t pass);
    [[nodiscard]] const targets::CableTurns& cable(std::size_t pass);

private:
    std::shared_ptr<const PassBook> m_book;
    std::unordered_map<std::size_t, Seconds> m_sunlit;
    std::unordered_map<std::size_t, targets::CableTurns> m_cable;
};

}  // namespace boresight::ui

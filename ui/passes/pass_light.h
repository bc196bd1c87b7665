// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_book.h"

#include <QString>

#include <vector>

// Whether the Sun shines on a satellite during its pass. Pure; it costs some milliseconds.
namespace boresight::ui {

struct PassLight
{
    bool isSunlitFirst = false;    // when the satellite rises
    std::vector<UtcTime> changes;  // to the second, from sunlight to shadow or back

    bool operator==(const PassLight&) const = default;
};

[[nodiscard]] PassLight lightOf(const BookedPass& one, const PassBook& book);
// One line: "in sunlight", "enters the shadow 17:05:59Z".
[[nodiscard]] QString lightText(const PassLight& light);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/site.h"

#include <QString>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

// Where a balloon or a rocket is, as its receiver reports it in one message. Whole or refused. Pure.
namespace boresight::position {

struct PositionText
{
    Site site;                                           // of what flies; longitude [-180°, 180°]
    QString name = {};                                   // its call sign; empty: none
    std::optional<std::chrono::milliseconds> time = {};  // of the day, UTC

    bool operator==(const PositionText&) const = default;
};

// No message of such a receiver has more.
inline constexpr std::size_t kLongestPosition = 4096;

// "38.757,-9.117,1200", with ",12:06:04" or an ISO time behind it if it has one; degrees and metres. Or a JSON object
// with latitude, longitude and altitude (or lat, lon and alt), as radiosonde_auto_rx and Horus send it: callsign and
// time are read, too. Refused with the reason, which repeats nothing of the text. 0, 0 is what a receiver without a fix
// sends, and is refused.
[[nodiscard]] Result<PositionText> readPosition(std::string_view text);

}  // namespace boresight::position

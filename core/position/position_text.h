// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/site.h"

#include <QString>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

// One message of a receiver about the position of a balloon or rocket. Complete or refused. Pure.
namespace boresight::position {

struct PositionText
{
    Site site;                                           // position of the object; longitude [-180°, 180°]
    QString name = {};                                   // its call sign; empty: none
    std::optional<std::chrono::milliseconds> time = {};  // of the day, UTC

    bool operator==(const PositionText&) const = default;
};

// Messages of such receivers are shorter.
inline constexpr std::size_t kLongestPosition = 4096;

// Reads "38.757,-9.117,1200" in degrees and metres, optionally followed by ",12:06:04" or an ISO time. Also reads a
// JSON object with latitude, longitude and altitude (or lat, lon and alt) as radiosonde_auto_rx and Horus send it, with
// optional callsign and time. Refused with a reason that quotes nothing from the text. 0, 0 is refused, because a
// receiver without a fix sends it.
[[nodiscard]] Result<PositionText> readPosition(std::string_view text);

}  // namespace boresight::position

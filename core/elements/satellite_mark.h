// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// The marks of the operator on a satellite: whether it is a favourite, a note of one line, and the antenna to track it
// with. Pure values.
namespace boresight::orbit {

enum class Favourite
{
    Off,
    On
};

struct SatelliteMark
{
    int number = 0;  // in the catalogue (NORAD)
    Favourite favourite = Favourite::Off;
    std::string note;
    std::string antenna = {};  // the name of the antenna; empty: the manually selected one

    bool operator==(const SatelliteMark&) const = default;
};

// Each satellite occurs once. A satellite without a mark is not in the list.
using SatelliteMarks = std::vector<SatelliteMark>;

inline constexpr std::size_t kLongestNote = 120;  // characters

[[nodiscard]] bool isFavourite(const SatelliteMarks& marks, std::int64_t number);
[[nodiscard]] std::string noteOf(const SatelliteMarks& marks, std::int64_t number);     // empty: none
[[nodiscard]] std::string antennaOf(const SatelliteMarks& marks, std::int64_t number);  // empty: no antenna of its own
void setFavourite(SatelliteMarks& marks, int number, bool on);
void setNote(SatelliteMarks& marks, int number, const std::string& note);
void setAntenna(SatelliteMarks& marks, int number, const std::string& antenna);

}  // namespace boresight::orbit

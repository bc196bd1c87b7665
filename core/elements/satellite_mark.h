// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What the operator keeps about a satellite: whether it is a favourite, and a note of one line. Pure values.
namespace boresight::orbit {

enum class Favourite
{
    Off,
    On
};

struct SatelliteMark
{
    int number = 0;  // in the catalogue
    Favourite favourite = Favourite::Off;
    std::string note;

    bool operator==(const SatelliteMark&) const = default;
};

// Each satellite once. One without a mark is not in the list.
using SatelliteMarks = std::vector<SatelliteMark>;

inline constexpr std::size_t kLongestNote = 120;  // characters

[[nodiscard]] bool isFavourite(const SatelliteMarks& marks, std::int64_t number);
[[nodiscard]] std::string noteOf(const SatelliteMarks& marks, std::int64_t number);  // empty: none
void setFavourite(SatelliteMarks& marks, int number, bool on);
void setNote(SatelliteMarks& marks, int number, const std::string& note);

}  // namespace boresight::orbit

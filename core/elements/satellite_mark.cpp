// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/satellite_mark.h"

#include <algorithm>

namespace boresight::orbit {

namespace {

const SatelliteMark* find(const SatelliteMarks& marks, std::int64_t number)
{
    const auto found = std::ranges::find(marks, number, &SatelliteMark::number);
    return found == marks.end() ? nullptr : &*found;
}

template <class Change>
void changeMark(SatelliteMarks& marks, int number, Change change)
{
    auto found = std::ranges::find(marks, number, &SatelliteMark::number);
    if (found == marks.end()) {
        found = marks.insert(marks.end(), SatelliteMark{.number = number, .note = {}});
    }
    change(*found);
    if (*found == SatelliteMark{.number = number, .note = {}}) {
        marks.erase(found);
    }
}

}  // namespace

bool isFavourite(const SatelliteMarks& marks, std::int64_t number)
{
    const SatelliteMark* const mark = find(marks, number);
    return mark != nullptr && mark->favourite == Favourite::On;
}

std::string noteOf(const SatelliteMarks& marks, std::int64_t number)
{
    const SatelliteMark* const mark = find(marks, number);
    return mark != nullptr ? mark->note : std::string();
}

std::string antennaOf(const SatelliteMarks& marks, std::int64_t number)
{
    const SatelliteMark* const mark = find(marks, number);
    return mark != nullptr ? mark->antenna : std::string();
}

void setFavourite(SatelliteMarks& marks, int number, bool on)
{
    changeMark(marks, number, [on](SatelliteMark& mark) { mark.favourite = on ? Favourite::On : Favourite::Off; });
}

void setNote(SatelliteMarks& marks, int number, const std::string& note)
{
    changeMark(marks, number, [&](SatelliteMark& mark) { mark.note = note; });
}

void setAntenna(SatelliteMarks& marks, int number, const std::string& antenna)
{
    changeMark(marks, number, [&](SatelliteMark& mark) { mark.antenna = antenna; });
}

}  // namespace boresight::orbit

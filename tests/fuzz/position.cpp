// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of a balloon: gives any bytes to readPosition(). An accepted position is a place on or above the Earth.
#include "core/base/control_characters.h"
#include "core/position/position_text.h"
#include "tests/fuzz/harness.h"

#include <cmath>
#include <string>

namespace boresight::fuzz {

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {"38.757,-9.117,1200\n", "-38.757,350.1,30.5,12:06:04.25Z",
                      "38.757,-9.117,1200,2026-11-27T12:06:04+00:00",
                      R"({"type":"PAYLOAD_SUMMARY","callsign":"V2850795","latitude":46.2590563,"longitude":13.1551694,)"
                      R"("altitude":1001.84319,"time":"12:06:04","fest":[-2250.0,2625.0]})",
                      R"({"lat":"46.5","lon":-13,"alt":0})"};
    grammar.tokens = {"latitude", "longitude",
                      "altitude", "callsign",
                      "time",     "lat",
                      "lon",      "alt",
                      "{",        "}",
                      "[",        "]",
                      "\"",       ":",
                      ",",        "null",
                      "true",     "nan",
                      "inf",      "1e9",
                      "-0",       "90",
                      "90.1",     "180",
                      "360",      "23:59:59.999",
                      "24:00:00", "T",
                      "Z",        "\\u0000",
                      "\\u001b",  "\n",
                      "\xff",     std::string(1, '\0')};
    grammar.separators = " ,:{}\"\n";
    grammar.maxLength = 600;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const Result<position::PositionText> read = position::readPosition(asText(input));
    if (!read) {
        require(!read.error().text.isEmpty() && read.error().text.size() < 120, "a refusal has a short reason");
        require(!hasControlCharacters(read.error().text.toStdString()), "the reason is printable");
        return;
    }
    const Site& site = read->site;
    require(std::abs(site.latitude.degrees()) <= 90.0 + 1e-9, "a latitude");
    require(std::abs(site.longitude.degrees()) <= 180.0 + 1e-9, "a longitude");
    require(site.heightMetres >= -1000.0 && site.heightMetres <= 2e6, "a height");
    require(!read->time || (read->time->count() >= 0 && *read->time < std::chrono::days(1)), "a time of the day");
    require(read->name.size() <= 40 && !hasControlCharacters(read->name.toStdString()), "a short printable name");
    accept();
}

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of an anemometer: any bytes to readWind(); what it accepts is a wind speed.
#include "core/base/control_characters.h"
#include "core/wind/wind_text.h"
#include "tests/fuzz/harness.h"

#include <string>

namespace boresight::fuzz {

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {"12.3\n", "wind 12.3\r\n", R"({"wind": 12.3, "dir": 270})", R"({"wind": {"speed": "7.5"}})"};
    grammar.tokens = {"wind", "speed", "{",   "}",    "[",
                      "]",    "\"",    ":",   ",",    ".",
                      "null", "true",  "nan", "inf",  "1e9",
                      "-0",   "150",   "151", "0x1f", "\\u0000",
                      "\n",   "\xff",  " ",   "-1",   std::string(1, '\0')};
    grammar.separators = " ,:{}\"\n";
    grammar.maxLength = 300;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    for (const char* const key : {"wind", "wind.speed"}) {
        const Result<double> read = wind::readWind(asText(input), {.key = key, .unit = wind::Unit::KilometresPerHour});
        if (!read) {
            require(!read.error().text.isEmpty() && read.error().text.size() < 120, "a refusal has a short reason");
            require(!hasControlCharacters(read.error().text.toStdString()), "the reason is printable");
            continue;
        }
        require(*read >= 0.0 && *read <= wind::kStrongest, "a wind speed");
        accept();
    }
}

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
// azel.dat: gives any bytes to readAzelText(). An accepted text is a direction in the sky at a time of day.
#include "core/azel/azel_text.h"
#include "core/base/control_characters.h"
#include "tests/fuzz/harness.h"

#include <cmath>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::azel;

bool isPlace(const SkyPointing& place)
{
    const double azimuth = place.azimuth.degrees();
    const double elevation = place.elevation.degrees();
    return azimuth >= 0.0 && azimuth < 360.0 && std::abs(elevation) <= 90.0 + 1e-9;
}

void checkText(const AzelText& read)
{
    require(isPlace(read.moon), "the Moon is in the sky or below it");
    require(!read.sun || isPlace(*read.sun), "so is the Sun");
    require(read.timeOfDay >= std::chrono::seconds(0) && read.timeOfDay < std::chrono::days(1), "a time of the day");
    for (const auto& number : {read.megahertz, read.dxDoppler, read.selfDoppler}) {
        require(!number || std::isfinite(*number), "a number is finite");
    }
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    const std::string places = "22:30:04,105.3, 59.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,  0.0,  0.0,Source\n";
    grammar.corpus = {places + " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler, R\n",
                      places + "*****,  2189.0,********,  1625.0,   -9.79,Doppler, T\n" +
                          "   -69.7,     0.0,    -0.5,   263.9,     0.0,Pol\n",
                      places + "1296,  2189,  1625,Doppler\n 125,1,fQSO\n 130,0,fQSO2",
                      "00:00:00,360.0, -0.0,Moon\r\n00:00:00,  0.0,-90.0,Sun\r\n 144,0,0,0,0,Doppler\r\n"};
    grammar.tokens = {"Moon",     "Sun",
                      "Source",   "Doppler",
                      "Pol",      "fQSO",
                      " R",       " T",
                      "360.0",    "-0.0",
                      "nan",      "inf",
                      "1e9",      "1e-9",
                      "-90",      "90.1",
                      "23:59:59", "24:00:00",
                      "-",        ".",
                      "*****",    "\r\n",
                      "\n",       "\x1b",
                      "\xff",     std::string(1, '\0')};
    grammar.separators = " ,:\n";
    grammar.maxLength = 600;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    const Result<AzelText> read = readAzelText(text);
    if (!read) {
        require(!read.error().text.isEmpty() && read.error().text.size() < 120, "a refusal has a short reason");
        require(!hasControlCharacters(read.error().text.toStdString()), "the reason is printable");
        return;
    }
    checkText(*read);
    const std::size_t end = text.rfind('\n') + 1;
    require(readAzelText(text.substr(0, end)) == read, "the last line without an end is not used");
    accept();
}

}  // namespace boresight::fuzz

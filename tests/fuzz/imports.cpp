// SPDX-License-Identifier: GPL-3.0-or-later
// Imports from other programs: gives any bytes to parseHorizon(), parseQth() and fromLocator(). An accepted result is
// valid in a profile.
#include "core/base/control_characters.h"
#include "core/gpredict/gpredict_qth.h"
#include "core/pointing/skyline.h"
#include "core/profile/horizon_text.h"
#include "core/profile/setting.h"
#include "core/targets/locator.h"
#include "tests/fakes/text_of.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

namespace boresight::fuzz {
namespace {

using namespace boresight::profile;
using namespace boresight::targets;

Profile lyingLow()
{
    Profile profile;
    profile.elevation.geometry.travel = {.min = -91_deg, .max = 91_deg};
    profile.park.elevation = 90_deg;  // above any horizon
    return profile;
}

void checkWrittenBack(const std::vector<pointing::HorizonPoint>& points)
{
    const auto again = parseHorizon(toHorizonText(points, "mast"), QStringLiteral("b.txt"));
    require(again.has_value() || points.size() + 1 > kMaxHorizonPoints, "a written horizon can be read");
    if (again) {
        const pointing::Skyline before(points);
        const pointing::Skyline after(again->points);
        for (const pointing::HorizonPoint& point : points) {
            const double apart = (before.at(point.azimuth) - after.at(point.azimuth)).degrees();
            require(std::abs(apart) < 1e-6, "a written horizon reads back as it was");
        }
    }
}

bool feedHorizon(std::string_view text)
{
    const auto horizon = parseHorizon(text, QStringLiteral("a.txt"));
    if (!horizon) {
        const std::string error = textOf(horizon.error());
        require(error.starts_with("a.txt:"), "the reason begins with the file");
        require(std::ranges::none_of(error, [](char c) { return c != '\n' && isControlCharacter(c); }),
                "the reason is printable");
        require(error.size() < 4096, "the reason is no longer than the file deserves");
        return false;
    }
    require(!horizon->points.empty(), "an accepted horizon has points");
    Profile profile = lyingLow();
    profile.limits.horizon = horizon->points;
    require(problemsOf(profile).empty(), "an accepted horizon is fit for a profile");
    checkWrittenBack(horizon->points);
    return true;
}

bool feedQth(std::string_view text)
{
    const auto station = parseQth(QByteArray(text.data(), static_cast<qsizetype>(text.size())), QStringLiteral("a"));
    if (!station) {
        require(!hasControlCharacters(textOf(station.error())), "the reason is one printable line");
        return false;
    }
    Profile profile;
    profile.site = station->site;
    require(profile.site.known && problemsOf(profile).empty(), "an accepted place is fit for a profile");
    return true;
}

bool feedLocator(std::string_view text)
{
    const auto place = fromLocator(text);
    if (!place) {
        require(!hasControlCharacters(textOf(place.error())), "the reason is one printable line");
        return false;
    }
    const auto again = toLocator(*place, static_cast<LocatorLength>(text.size()));
    require(again.has_value() && std::ranges::equal(*again, text, {}, ::tolower, ::tolower),
            "the centre of a square is in it");
    return true;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {"# N.I.N.A.\n0 10\n90 20\n180 30\n270 20\n360 10\n",
                      "azimuth,elevation\n1, 15\n2,19\n18 , 37\n",
                      "12,5;3,25\r\n100;4\r\n",
                      "10 0\n10 20\n30 20\n30 0\n",
                      "[QTH]\nLOCATION=Lisboa, Portugal\nLAT=38.7223\nLON=-9.1393\nALT=102\nQTH_TYPE=0\n",
                      "JN58",
                      "FN31pr",
                      "QF56od51",
                      "JN58td25ul"};
    grammar.tokens = {"#",   ",",    ";",     "\t",  "\n",     "\r\n",         "359.9999999", "360",   "-90",
                      "90",  "1e1",  "1e300", "nan", "0.0001", "\xef\xbb\xbf", "\x1b",        "\xff",  "[QTH]\n",
                      "LAT", "LON=", "ALT=1", "=",   "180",    "-180",         "AA00aa00aa",  "RR99xx"};
    grammar.separators = " ,;\n=";
    grammar.maxLength = 512;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    const bool isHorizon = feedHorizon(text);
    const bool isPlace = feedQth(text);
    const bool isLocator = feedLocator(text);
    if (isHorizon || isPlace || isLocator) {
        accept();
    }
}

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pairs_server/pairs_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/rotctld/client_angles.h"
#include "core/rotctld/client_habits.h"
#include "core/targets/locator.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace boresight::pairs {
namespace {

using rotctld::shownText;

std::vector<std::string> wordsOf(std::string_view line)
{
    constexpr std::string_view kBlanks = " \t";
    std::vector<std::string> words;
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;
         at = line.find_first_not_of(kBlanks, at)) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.emplace_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char one) { return static_cast<char>(std::tolower(static_cast<unsigned char>(one))); });
    return text;
}

tl::unexpected<Error> unknown(std::string_view line)
{
    return failure(ErrorCode::InvalidInput,
                   Text::tr("\"%1\" is not a command. The commands are ELEVATION, AZIMUTH ELEVATION, +AZIMUTH "
                            "+ELEVATION, bearing LOCATOR, bearing LOCATOR long, stop, hold, park and ?")
                       .arg(shownText(line)));
}

std::optional<Angle> angleIn(const std::string& word)
{
    if (word.find_first_not_of("+-.0123456789") != std::string::npos) {
        return std::nullopt;
    }
    const auto degrees = parseFinite(word);
    return degrees ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
}

// True for a number with a sign, and for zero.
bool isStep(const std::string& word)
{
    return word.front() == '+' || word.front() == '-' || angleIn(word) == Angle{};
}

Result<Command> parseNumbers(const std::vector<std::string>& words, std::string_view line)
{
    const auto last = angleIn(words.back());
    const auto first = angleIn(words.front());
    if (words.size() > 2 || !last || !first) {
        return unknown(line);
    }
    const bool both = words.size() == 2;
    if (line.find('+') != std::string_view::npos) {
        if (!isStep(words.front()) || !isStep(words.back())) {
            return unknown(line);  // a mixture of an angle and a step
        }
        return Command(MoveBy{.azimuth = both ? *first : Angle{}, .elevation = *last});
    }
    return rotctld::inReach(both ? *first : Angle{}, *last).map([&] {
        return Command(Place{.azimuth = both ? first : std::nullopt, .elevation = *last});
    });
}

Result<Command> parseBearing(const std::vector<std::string>& words, std::string_view line)
{
    const bool isLong = words.size() == 3 && lowered(words[2]) == "long";
    if (words.size() != 2 && !isLong) {
        return unknown(line);
    }
    return targets::fromLocator(words[1]).map([&](const targets::GeoPoint& place) {
        const targets::EarthPosition position{
            .site = {.latitude = place.latitude, .longitude = place.longitude},
            .path = isLong ? targets::GreatCircle::Long : targets::GreatCircle::Short};
        return Command(Bearing{{.name = toQString(words[1]), .kind = position}});
    });
}

}  // namespace

bool endsInStop(std::string_view line)
{
    const std::vector<std::string> words = wordsOf(line);
    return !words.empty() && lowered(words.back()) == "stop";
}

bool isHold(std::string_view line)
{
    const std::vector<std::string> words = wordsOf(line);
    return words.size() == 1 && lowered(words.front()) == "hold";
}

Result<Command> parseLine(std::string_view line)
{
    const std::vector<std::string> words = wordsOf(line);
    const std::string word = words.empty() ? std::string() : lowered(words.front());
    if (word == "bearing") {
        return parseBearing(words, line);
    }
    if (words.size() == 1 && word == "?") {
        return Command(Report{});
    }
    if (words.size() == 1 && (word == "stop" || word == "hold")) {
        return Command(Stop{});
    }
    if (words.size() == 1 && word == "park") {
        return Command(Park{});
    }
    return words.empty() ? unknown(line) : parseNumbers(words, line);
}

// A step beyond a limit is refused. It never makes the mount go round the other way.
Result<SkyPointing> movedBy(const SkyPointing& from, const MoveBy& move, const rotctld::Limits& limits)
{
    const SkyPointing to{.azimuth = limits.turned(from.azimuth + move.azimuth),
                         .elevation = from.elevation + move.elevation};
    if (limits.nearest(to) != to) {
        return failure(ErrorCode::OutOfRange, Text::tr("The step leads to %1 / %2, outside the limits.")
                                                  .arg(degreesText(to.azimuth, 1), degreesText(to.elevation, 1)));
    }
    return to;
}

std::string doneAs(const QString& became)
{
    return became.isEmpty() ? std::string(kDone) : "OK: " + became.simplified().toStdString() + "\n";
}

std::string reportOf(const SkyPointing& place)
{
    return formatFixed(place.azimuth.degrees(), 1) + " " + formatFixed(place.elevation.degrees(), 1) + "\n";
}

std::string refusalOf(const Error& error)
{
    return "error: " + error.text.simplified().toStdString() + "\n";
}

}  // namespace boresight::pairs

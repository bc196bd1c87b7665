// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_server/client_words.h"

#include "core/base/text.h"
#include "core/gs232/box_command.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace boresight::gs232 {
namespace {

using rotctld::MoveDirection;

constexpr std::size_t kDigits = 3;

std::string upper(std::string_view line)
{
    std::string text(line);
    std::ranges::transform(text, text.begin(),
                           [](char one) { return static_cast<char>(std::toupper(static_cast<unsigned char>(one))); });
    return text;
}

tl::unexpected<Error> unknown()
{
    return failure(ErrorCode::InvalidInput, Text::tr("this is not a GS-232 command"));
}

// "123" is 123°. Exactly three digits, as in the box.
std::optional<Angle> threeDigits(std::string_view text)
{
    int value = 0;
    for (const char one : text) {
        if (one < '0' || one > '9') {
            return std::nullopt;
        }
        value = 10 * value + (one - '0');
    }
    return text.size() == kDigits ? std::optional(Angle::fromDegrees(value)) : std::nullopt;
}

Result<PointTo> inReach(const PointTo& place)
{
    if (!kAzimuthReach.contains(place.azimuth)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("azimuth %1 is outside 0°…450°").arg(degreesText(place.azimuth, 0)));
    }
    if (place.elevation && !kElevationReach.contains(*place.elevation)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("elevation %1 is outside 0°…180°").arg(degreesText(*place.elevation, 0)));
    }
    return place;
}

// The number of groups of three digits with one blank between them. 0 for any other text.
std::size_t groupsIn(std::string_view text)
{
    std::size_t count = 0;
    while (threeDigits(text.substr(0, kDigits))) {
        ++count;
        text.remove_prefix(kDigits);
        if (text.empty()) {
            return count;
        }
        if (text.front() != ' ') {
            return 0;
        }
        text.remove_prefix(1);
    }
    return 0;
}

// "M123" or "W123 045". More groups are a list with times.
Result<ClientCommand> parsePoint(std::string_view text)
{
    const std::size_t wanted = text.front() == 'M' ? 1 : 2;
    const std::string_view angles = text.substr(1);
    const std::size_t groups = groupsIn(angles);
    if (groups > wanted) {
        return failure(ErrorCode::NotAvailable, Text::tr("lists of positions are not supported"));
    }
    if (groups < wanted) {
        return unknown();
    }
    PointTo place{.azimuth = *threeDigits(angles.substr(0, kDigits)), .elevation = {}};
    if (wanted == 2) {
        place.elevation = threeDigits(angles.substr(kDigits + 1));
    }
    return inReach(place).map([](const PointTo& good) { return ClientCommand(good); });
}

struct Word
{
    std::string_view text;
    ClientCommand command;
};

const std::array kWords{Word{"C", Ask::Azimuth},
                        Word{"B", Ask::Elevation},
                        Word{"C2", Ask::Both},
                        Word{"R", Turn{MoveDirection::Right}},
                        Word{"L", Turn{MoveDirection::Left}},
                        Word{"U", Turn{MoveDirection::Up}},
                        Word{"D", Turn{MoveDirection::Down}},
                        Word{"S", StopTurning{}},
                        Word{"A", StopTurning{}},
                        Word{"E", StopTurning{}},
                        Word{"X1", Speed{1}},
                        Word{"X2", Speed{2}},
                        Word{"X3", Speed{3}},
                        Word{"X4", Speed{4}}};

constexpr std::array<std::string_view, 11> kNotOffered{"T", "N", "O", "O2", "F", "F2", "P36", "P45", "Z", "H", "H2"};

Result<std::string> digitsOf(Angle angle, const TravelRange& reach, const QString& outside)
{
    const long value = std::lround(angle.degrees());
    if (!angle.isFinite() || !reach.contains(Angle::fromDegrees(static_cast<double>(value)))) {
        return failure(ErrorCode::OutOfRange, outside.arg(degreesText(angle, 1)));
    }
    const std::string digits = std::to_string(value);
    return std::string(kDigits - digits.size(), '0') + digits;
}

// In the count of the box: 370° is not 10°. An azimuth that this count does not have is wrapped to 0…360°.
Result<std::string> azimuthDigits(Angle azimuth)
{
    const bool counted = azimuth >= kAzimuthReach.min && azimuth <= kAzimuthReach.max;
    return digitsOf(counted ? azimuth : azimuth.wrapped360(), kAzimuthReach,
                    Text::tr("GS-232 has no number for the azimuth %1"));
}

}  // namespace

Result<ClientCommand> parseCommand(std::string_view line)
{
    const std::string text = upper(line);
    const auto* const word = std::ranges::find(kWords, text, &Word::text);
    if (word != kWords.end()) {
        return word->command;
    }
    if (std::ranges::find(kNotOffered, text) != kNotOffered.end()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this command of GS-232 is not supported"));
    }
    return text.starts_with('M') || text.starts_with('W') ? parsePoint(text) : unknown();
}

Result<std::string> answerTo(Ask question, const SkyPointing& place, Dialect dialect)
{
    const bool a = dialect == Dialect::A;
    std::string answer;
    if (question != Ask::Elevation) {
        const auto digits = azimuthDigits(place.azimuth);
        if (!digits) {
            return digits;
        }
        answer += (a ? "+0" : "AZ=") + *digits;
    }
    if (question != Ask::Azimuth) {
        const auto digits =
            digitsOf(place.elevation, kElevationReach, Text::tr("GS-232 has no number for the elevation %1"));
        if (!digits) {
            return digits;
        }
        answer += (a ? "+0" : question == Ask::Both ? "  EL=" : "EL=") + *digits;
    }
    return answer + "\r\n";
}

}  // namespace boresight::gs232

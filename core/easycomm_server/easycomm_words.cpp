// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/easycomm_server/easycomm_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/rotctld/client_habits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace boresight::easycomm {
namespace {

using rotctld::MoveDirection;
using rotctld::shownText;

constexpr std::size_t kMostWords = 16;

struct Word
{
    std::string_view text;
    Command command;
    Version since;
};

const std::array kWords{Word{"AZ", Ask::Azimuth, Version::One},
                        Word{"EL", Ask::Elevation, Version::One},
                        Word{"SA", StopTurning{}, Version::One},
                        Word{"SE", StopTurning{}, Version::One},
                        Word{"STOP", StopTurning{}, Version::One},
                        Word{"VE", Ask::Version, Version::Two},
                        Word{"ML", Turn{MoveDirection::Left}, Version::Two},
                        Word{"MR", Turn{MoveDirection::Right}, Version::Two},
                        Word{"MU", Turn{MoveDirection::Up}, Version::Two},
                        Word{"MD", Turn{MoveDirection::Down}, Version::Two},
                        Word{"PARK", Park{}, Version::Two},
                        Word{"RESET", Reset{}, Version::Two},
                        Word{"GS", Ask::Status, Version::Three},
                        Word{"GE", Ask::Errors, Version::Three}};

struct Velocity
{
    std::string_view text;
    MoveDirection direction;
};

constexpr std::array kVelocities{Velocity{"VL", MoveDirection::Left}, Velocity{"VR", MoveDirection::Right},
                                 Velocity{"VU", MoveDirection::Up}, Velocity{"VD", MoveDirection::Down}};

// Frequencies, modes and numbers of radios, begin and end of a pass, the clock, outputs.
constexpr std::array<std::string_view, 10> kNotForARotator{"UP", "DN", "UM", "DM", "UR", "DR", "AO", "LO", "ST", "OP"};
// Registers and inputs of a real controller.
constexpr std::array<std::string_view, 4> kNotOffered{"CR", "CW", "IP", "AN"};

std::string upper(std::string_view line)
{
    std::string text(line);
    std::ranges::transform(text, text.begin(),
                           [](char one) { return static_cast<char>(std::toupper(static_cast<unsigned char>(one))); });
    return text;
}

// Hamlib leaves a semicolon after the line end of some questions, so a semicolon counts as a blank.
std::vector<std::string_view> wordsOf(std::string_view line)
{
    constexpr std::string_view kBetween = " \t;";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;
         at = line.find_first_not_of(kBetween, at)) {
        const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

tl::unexpected<Error> unknown(std::string_view word)
{
    return failure(ErrorCode::InvalidInput, Text::tr("\"%1\" is not an EasyComm command").arg(shownText(word)));
}

// "123.4", "-5", "+7.25". Also "123,4", from a program that writes numbers in the language of its user.
std::optional<double> numberIn(std::string_view text)
{
    std::string number(text);
    if (number.find_first_not_of("+-.,0123456789") != std::string::npos) {
        return std::nullopt;
    }
    if (const std::size_t comma = number.find(','); comma != std::string::npos) {
        number[comma] = '.';
    }
    return parseFinite(number);
}

Result<Command> parseAngle(std::string_view word)
{
    constexpr double kMostAzimuth = 3600.0;
    constexpr double kLowest = -90.0;
    constexpr double kHighest = 180.0;
    const auto degrees = numberIn(word.substr(2));
    if (!degrees) {
        return unknown(word);
    }
    const Angle angle = Angle::fromDegrees(*degrees);
    if (word.starts_with("AZ")) {
        if (std::abs(*degrees) > kMostAzimuth) {
            return failure(ErrorCode::OutOfRange, Text::tr("\"%1\" is outside -3600°…3600°").arg(shownText(word)));
        }
        return Command(Target{.azimuth = angle, .elevation = {}});
    }
    if (*degrees < kLowest || *degrees > kHighest) {
        return failure(ErrorCode::OutOfRange, Text::tr("\"%1\" is outside -90°…180°").arg(shownText(word)));
    }
    return Command(Target{.azimuth = {}, .elevation = angle});
}

// "VL0500" is 0.5°/s.
Result<Command> parseVelocity(std::string_view word, MoveDirection direction)
{
    constexpr std::size_t kMostDigits = 6;
    constexpr double kMillidegrees = 1000.0;
    const std::string_view digits = word.substr(2);
    std::optional<std::int64_t> value;
    if (digits.size() <= kMostDigits && digits.find_first_not_of("0123456789") == std::string_view::npos) {
        value = parseInteger(digits);
    }
    if (!value) {
        return unknown(word);
    }
    const Angle each = Angle::fromDegrees(static_cast<double>(*value) / kMillidegrees);
    return Command(Turn{.direction = direction, .rate = each / Seconds(1.0)});
}

Result<Command> parseWord(std::string_view word, Version version)
{
    const auto* const found = std::ranges::find(kWords, word, &Word::text);
    if (found != kWords.end() && version >= found->since) {
        return found->command;
    }
    const std::string_view letters = word.substr(0, 2);
    if (word.size() > 2 && (letters == "AZ" || letters == "EL")) {
        return parseAngle(word);
    }
    const auto* const velocity = std::ranges::find(kVelocities, letters, &Velocity::text);
    if (velocity != kVelocities.end() && version == Version::Three) {
        return parseVelocity(word, velocity->direction);
    }
    // "STOPP" is a typing error, not a command for the clock.
    const bool isMistyped =
        letters == "ST" && word.size() > 2 && std::isdigit(static_cast<unsigned char>(word[2])) == 0;
    if (found == kWords.end() && !isMistyped && std::ranges::find(kNotForARotator, letters) != kNotForARotator.end()) {
        return Command(NotForARotator{});
    }
    if (std::ranges::find(kNotOffered, letters) != kNotOffered.end()) {
        return failure(ErrorCode::NotAvailable, Text::tr("registers and inputs are not supported"));
    }
    return unknown(word);
}

// In "UP145900000 FM DN435000000 SSB" the mode is a separate word.
bool isMode(std::string_view word, std::string_view before)
{
    const bool frequency = before.starts_with("UP") || before.starts_with("DN");
    const bool letters = std::ranges::all_of(word, [](unsigned char one) { return std::isalpha(one) != 0; });
    return frequency && letters && std::ranges::find(kWords, word, &Word::text) == kWords.end();
}

// Joins "AZ123.4 EL45.6" into one target.
bool joins(std::vector<Command>& commands, const Command& next)
{
    const auto* const more = std::get_if<Target>(&next);
    auto* const last = more == nullptr || commands.empty() ? nullptr : std::get_if<Target>(&commands.back());
    if (last == nullptr || (more->azimuth ? last->azimuth : last->elevation)) {
        return false;
    }
    (more->azimuth ? last->azimuth : last->elevation) = more->azimuth ? more->azimuth : more->elevation;
    return true;
}

bool moves(const Command& command)
{
    return std::holds_alternative<Target>(command) || std::holds_alternative<Turn>(command) ||
           std::holds_alternative<Park>(command) || std::holds_alternative<Reset>(command);
}

}  // namespace

bool hasStop(std::string_view line)
{
    const std::string text = upper(line);
    return std::ranges::any_of(wordsOf(text),
                               [](std::string_view word) { return word == "SA" || word == "SE" || word == "STOP"; });
}

Result<std::vector<Command>> parseLine(std::string_view line, Version version)
{
    const std::string text = upper(line);
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.size() > kMostWords) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a line has more than %1 words").arg(QString::number(kMostWords)));
    }
    std::vector<Command> commands;
    std::string_view before;
    for (const std::string_view word : words) {
        if (!isMode(word, std::exchange(before, word))) {
            const auto command = parseWord(word, version);
            if (!command) {
                return tl::unexpected(command.error());
            }
            if (!joins(commands, *command)) {
                commands.push_back(*command);
            }
        }
    }
    if (std::ranges::count_if(commands, moves) > 1) {
        return failure(ErrorCode::InvalidInput, Text::tr("a line asks for two motions"));
    }
    return commands;
}

std::string azimuthAnswer(Angle azimuth)
{
    return "AZ" + formatFixed(azimuth.degrees(), 1);
}

std::string elevationAnswer(Angle elevation)
{
    return "EL" + formatFixed(elevation.degrees(), 1);
}

std::string alarmOf(const Error& error)
{
    switch (error.code) {
        case ErrorCode::InvalidInput:
            return "ALnot-understood";
        case ErrorCode::OutOfRange:
            return "ALoutside-limits";
        case ErrorCode::NotAvailable:
            return "ALnot-supported";
        case ErrorCode::Refused:
        case ErrorCode::Busy:
        case ErrorCode::Denied:
            return "ALrefused";
        case ErrorCode::NoAnswer:
        case ErrorCode::NoDevice:
        case ErrorCode::Io:
        case ErrorCode::Protocol:
            break;
    }
    return "ALno-position";
}

}  // namespace boresight::easycomm

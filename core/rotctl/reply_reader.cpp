// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/reply_reader.h"

#include "core/base/numbers.h"

#include <array>
#include <utility>

namespace boresight::rotctl {
namespace {

constexpr int kWorstError = 99;

std::string_view withoutBlanks(std::string_view text)
{
    const auto from = text.find_first_not_of(" \t");
    if (from == std::string_view::npos) {
        return {};
    }
    return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

// "RPRT -1" gives -1. Errors of Hamlib are negative.
std::optional<int> codeOf(std::string_view line)
{
    constexpr std::string_view kReport = "RPRT ";
    if (!line.starts_with(kReport)) {
        return std::nullopt;
    }
    const auto code = parseInteger(line.substr(kReport.size()));
    return code && *code <= 0 && *code >= -kWorstError ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

std::optional<Angle> angleOf(std::string_view text, const TravelRange& possible)
{
    const auto degrees = parseFinite(withoutBlanks(text));
    const auto angle = degrees ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
    return angle && possible.contains(*angle) ? angle : std::nullopt;
}

std::optional<int> smallInteger(std::string_view text)
{
    constexpr int kMost = 1000000;
    const auto number = parseInteger(withoutBlanks(text));
    return number && *number >= 0 && *number <= kMost ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

// The first line of an extended answer begins with the long name of the command.
std::string_view headOf(Question question)
{
    switch (question) {
        case Question::State:
            return "dump_state:";
        case Question::Position:
            return "get_pos:";
        case Question::Order:
            return "set_pos:";
        case Question::Reset:
            return "reset:";
        case Question::Stop:
            break;
    }
    return "stop:";
}

// The answer has no values.
bool isOrder(Question question)
{
    return question != Question::State && question != Question::Position;
}

RotatorType typeOf(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, RotatorType>, 3> kTypes{
        {{"AzEl", RotatorType::AzEl}, {"Az", RotatorType::Az}, {"El", RotatorType::El}}};
    for (const auto& [name, type] : kTypes) {
        if (text == name) {
            return type;
        }
    }
    return RotatorType::Unknown;
}

}  // namespace

bool isReport(std::string_view line)
{
    return codeOf(withoutBlanks(line)).has_value();
}

ReplyReader::Progress ReplyReader::take(std::string_view line)
{
    const std::string_view text = withoutBlanks(line);
    if (++m_lines > kMostLines) {
        return Progress::Strange;
    }
    return m_form == Form::Extended ? takeExtended(text) : takePlain(text);
}

ReplyReader::Progress ReplyReader::takeExtended(std::string_view line)
{
    if (const auto code = codeOf(line)) {
        // Some imitations send an error without the first line.
        return m_lines > 1 || *code < 0 ? end(*code) : Progress::Strange;
    }
    if (m_lines == 1) {
        return line.starts_with(headOf(m_question)) ? Progress::More : Progress::Strange;
    }
    return takeValue(line) ? Progress::More : Progress::Strange;
}

// Values that later versions add are ignored.
bool ReplyReader::takeValue(std::string_view line)
{
    const std::size_t colon = line.find_first_of(":=");
    const std::string_view label = line.substr(0, colon);
    const std::string_view value =
        colon == std::string_view::npos ? std::string_view() : withoutBlanks(line.substr(colon + 1));
    const auto put = [&](std::optional<Angle>& into, const TravelRange& possible) {
        into = angleOf(value, possible);
        return into.has_value();
    };
    if (label == "Azimuth") {
        return put(m_numbers.azimuth, kPossibleAzimuth);
    }
    if (label == "Elevation") {
        return put(m_numbers.elevation, kPossibleElevation);
    }
    if (label == "Minimum Azimuth" || label == "min_az") {
        return put(m_numbers.minAzimuth, kPossibleAzimuth);
    }
    if (label == "Maximum Azimuth" || label == "max_az") {
        return put(m_numbers.maxAzimuth, kPossibleAzimuth);
    }
    if (label == "Minimum Elevation" || label == "min_el") {
        return put(m_numbers.minElevation, kPossibleElevation);
    }
    if (label == "Maximum Elevation" || label == "max_el") {
        return put(m_numbers.maxElevation, kPossibleElevation);
    }
    if (label == "rot_type") {
        m_numbers.type = typeOf(value);
    }
    return true;
}

ReplyReader::Progress ReplyReader::takePlain(std::string_view line)
{
    if (const auto code = codeOf(line)) {
        return isOrder(m_question) || (*code < 0 && m_lines == 1) ? end(*code) : Progress::Strange;
    }
    switch (m_question) {
        case Question::Position:
            return takeNumber(line, 0);
        case Question::State:
            return takePlainState(line);
        case Question::Order:
        case Question::Stop:
        case Question::Reset:
            break;
    }
    return Progress::Strange;
}

// The version of the protocol, the model, and the limits. Version 0 has four bare numbers, version 1 has names with
// values up to "done". A server that supports clients of both ages sends both.
ReplyReader::Progress ReplyReader::takePlainState(std::string_view line)
{
    constexpr int kLast = 6;
    if (m_lines <= 2) {
        const auto number = smallInteger(line);
        m_numbers.version = m_lines == 1 ? number.value_or(0) : m_numbers.version;
        return number ? Progress::More : Progress::Strange;
    }
    if (m_numbers.version >= 1 && line == "done") {
        return end(0);
    }
    if (m_numbers.version >= 1 && line.find('=') != std::string_view::npos) {
        return takeValue(line) ? Progress::More : Progress::Strange;
    }
    if (m_lines > kLast) {
        return Progress::Strange;
    }
    const Progress progress = takeNumber(line, m_lines - 2);
    return progress == Progress::More && m_lines == kLast && m_numbers.version == 0 ? end(0) : progress;
}

// A line with only a number. `limit` 0: an angle of the position. Otherwise: the limit with this number.
ReplyReader::Progress ReplyReader::takeNumber(std::string_view line, int limit)
{
    const bool isAzimuth = limit == 0 ? m_lines == 1 : limit <= 2;
    const auto angle = angleOf(line, isAzimuth ? kPossibleAzimuth : kPossibleElevation);
    if (!angle) {
        return Progress::Strange;
    }
    const std::array<std::optional<Angle>*, 5> into{isAzimuth ? &m_numbers.azimuth : &m_numbers.elevation,
                                                    &m_numbers.minAzimuth, &m_numbers.maxAzimuth,
                                                    &m_numbers.minElevation, &m_numbers.maxElevation};
    *into[static_cast<std::size_t>(limit)] = angle;
    return limit == 0 && m_lines == 2 ? end(0) : Progress::More;
}

ReplyReader::Progress ReplyReader::end(int code)
{
    m_reply = Reply{.code = code, .state = {}, .position = {}};
    if (code < 0 || isOrder(m_question)) {
        return Progress::Whole;
    }
    const Numbers& all = m_numbers;
    if (m_question == Question::Position) {
        if (!all.azimuth || !all.elevation) {
            return Progress::Strange;
        }
        m_reply.position = AxisPosition{.azimuth = *all.azimuth, .elevation = *all.elevation};
        return Progress::Whole;
    }
    if (!all.minAzimuth || !all.maxAzimuth || !all.minElevation || !all.maxElevation) {
        return Progress::Strange;
    }
    m_reply.state = RotatorState{.azimuth = {.min = *all.minAzimuth, .max = *all.maxAzimuth},
                                 .elevation = {.min = *all.minElevation, .max = *all.maxElevation},
                                 .type = all.type};
    return Progress::Whole;
}

}  // namespace boresight::rotctl

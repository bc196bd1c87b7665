// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/box_reply.h"

#include "core/base/numbers.h"
#include "core/gs232/box_command.h"

#include <algorithm>

namespace boresight::gs232 {
namespace {

// Larger than the count of any of these boxes.
constexpr double kMostAzimuth = 540.0;
constexpr double kMostElevation = 270.0;

bool isDigit(char one)
{
    return one >= '0' && one <= '9';
}

std::string_view withoutBlanks(std::string_view text)
{
    const auto from = text.find_first_not_of(" \t");
    if (from == std::string_view::npos) {
        return {};
    }
    return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

struct Field
{
    Angle value;
    std::size_t digits = 0;  // before the point
};

// Removes "[sign]ddd[d][.d…]" from the front of `text` and returns its value.
std::optional<Field> takeNumber(std::string_view& text)
{
    const bool sign = !text.empty() && (text.front() == '+' || text.front() == '-');
    const std::size_t first = sign ? 1 : 0;
    const auto notDigit = [](std::string_view all, std::size_t from) {
        return static_cast<std::size_t>(
            std::find_if_not(all.begin() + static_cast<std::ptrdiff_t>(std::min(from, all.size())), all.end(),
                             isDigit) -
            all.begin());
    };
    std::size_t end = notDigit(text, first);
    const std::size_t digits = end - std::min(first, end);
    if (digits < 3 || digits > 4) {
        return std::nullopt;
    }
    if (end < text.size() && text[end] == '.') {
        const std::size_t point = end;
        end = notDigit(text, point + 1);
        if (end == point + 1) {
            return std::nullopt;  // the decimals are missing
        }
    }
    const auto value = parseFinite(text.substr(text.front() == '+' ? 1 : 0, end - (text.front() == '+' ? 1 : 0)));
    text.remove_prefix(end);
    return value ? std::optional(Field{.value = Angle::fromDegrees(*value), .digits = digits}) : std::nullopt;
}

// A name without a number is not removed, so the line does not count as complete.
std::optional<Field> takeNamed(std::string_view& text, std::string_view name)
{
    if (!text.starts_with(name)) {
        return std::nullopt;
    }
    std::string_view rest = withoutBlanks(text.substr(name.size()));
    const auto number = takeNumber(rest);
    text = number ? rest : text;
    return number;
}

bool isPossible(const std::optional<Field>& field, double most)
{
    return !field || (field->value.degrees() >= -180.0 && field->value.degrees() <= most);
}

// Two numbers of one line must have the same number of digits: "+0180+009" has lost its end.
Reply positionOf(Dialect dialect, const std::optional<Field>& azimuth, const std::optional<Field>& elevation)
{
    const bool uneven = azimuth && elevation && azimuth->digits != elevation->digits;
    if (uneven || !isPossible(azimuth, kMostAzimuth) || !isPossible(elevation, kMostElevation)) {
        return Unknown{};
    }
    Position position{.dialect = dialect, .azimuth = {}, .elevation = {}};
    if (azimuth) {
        position.azimuth = azimuth->value;
    }
    if (elevation) {
        position.elevation = elevation->value;
    }
    return position;
}

Reply parseA(std::string_view text)
{
    const auto isSigned = [&text] { return text.starts_with('+') || text.starts_with('-'); };
    const auto azimuth = takeNumber(text);
    text = withoutBlanks(text);
    if (!azimuth || text.empty()) {
        return azimuth ? positionOf(Dialect::A, azimuth, std::nullopt) : Reply(Unknown{});
    }
    const auto elevation = isSigned() ? takeNumber(text) : std::nullopt;
    return elevation && text.empty() ? positionOf(Dialect::A, azimuth, elevation) : Reply(Unknown{});
}

Reply parseB(std::string_view text)
{
    const auto azimuth = takeNamed(text, "AZ=");
    text = withoutBlanks(text);
    const auto elevation = takeNamed(text, "EL=");
    return (azimuth || elevation) && text.empty() ? positionOf(Dialect::B, azimuth, elevation) : Reply(Unknown{});
}

}  // namespace

Reply parseReply(std::string_view line)
{
    std::string_view text = withoutBlanks(line);
    if (text == "?>" || text == "?") {
        return Refused{};
    }
    // A box with a prompt writes it before the next line.
    while (text.starts_with('>')) {
        text = withoutBlanks(text.substr(1));
    }
    if (text.empty()) {
        return Nothing{};
    }
    if (isOwnCommand(text)) {
        return Echo{};
    }
    return text.front() == '+' || text.front() == '-' ? parseA(text) : parseB(text);
}

}  // namespace boresight::gs232

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/power/power_text.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QByteArray>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace boresight::power {
namespace {

constexpr std::string_view kOfNumber = "+-.,0123456789eE";
constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kBlanks = " \t\r\n";

bool isLetter(char character)
{
    const auto code = static_cast<unsigned char>(character);
    return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || code == '_' || code == '%' || code >= 0x80;
}

// Takes a decimal point, or one decimal comma ("-73,2"). A comma or point at the end is not part of the number.
std::optional<double> numberOf(std::string_view text)
{
    std::string pointed(text.substr(0, text.find_last_not_of(",.eE") + 1));
    if (pointed.find('.') == std::string::npos && std::count(pointed.begin(), pointed.end(), ',') == 1) {
        std::replace(pointed.begin(), pointed.end(), ',', '.');
    }
    return parseFinite(pointed);
}

struct Found
{
    std::optional<double> value;  // empty: digits that are not clearly one number, such as those of a date
    QByteArray unit;              // the word after the number, in lower case

    [[nodiscard]] bool isPower() const { return unit.startsWith("db"); }
    [[nodiscard]] bool isFrequency() const { return unit.endsWith("hz"); }
};

// The first word of the line, in lower case. Empty if the line does not begin with a letter.
QByteArray wordAhead(std::string_view line)
{
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    const auto end = std::find_if_not(line.begin(), line.end(), isLetter);
    return QByteArray(line.data(), end - line.begin()).toLower();
}

// With blanks between sign and number it is not clear whether the sign belongs to the number.
bool followsSign(std::string_view before)
{
    const std::size_t last = before.find_last_not_of(kBlanks);
    return last != std::string_view::npos && (before[last] == '-' || before[last] == '+');
}

// All numbers of the line, without those at the end of a word ("S7").
std::vector<Found> numbersIn(std::string_view line)
{
    std::vector<Found> numbers;
    std::size_t start = 0;
    while ((start = line.find_first_of(kOfNumber, start)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_not_of(kOfNumber, start), line.size());
        const std::string_view text = line.substr(start, end - start);
        const bool isSigned = text.front() == '-' || text.front() == '+';
        const bool touchesWord = start > 0 && isLetter(line[start - 1]);
        const bool hasDigit = text.find_first_of(kDigits) != std::string_view::npos;
        if (hasDigit && (!touchesWord || isSigned)) {
            const bool isSure = !touchesWord && !followsSign(line.substr(0, start)) && !isLetter(text.front());
            numbers.push_back({isSure ? numberOf(text) : std::nullopt, wordAhead(line.substr(end))});
        }
        start = end;
    }
    return numbers;
}

Result<double> onlyOne(const std::vector<Found>& numbers)
{
    if (numbers.empty()) {
        return failure(ErrorCode::InvalidInput, Text::tr("it contains no number"));
    }
    if (numbers.size() > 1) {
        return failure(ErrorCode::InvalidInput, Text::tr("it contains several numbers, and none is clearly the power"));
    }
    if (!numbers.front().value) {
        return failure(ErrorCode::InvalidInput, Text::tr("its number is ambiguous"));
    }
    if (!(std::abs(*numbers.front().value) <= kLargestPower)) {
        return failure(ErrorCode::OutOfRange, Text::tr("a power above %1 dB is not possible").arg(kLargestPower));
    }
    return *numbers.front().value;
}

}  // namespace

Result<double> parsePower(std::string_view line)
{
    std::vector<Found> numbers = numbersIn(line);
    if (std::any_of(numbers.begin(), numbers.end(), [](const Found& one) { return one.isPower(); })) {
        std::erase_if(numbers, [](const Found& one) { return !one.isPower(); });
        return onlyOne(numbers);
    }
    std::erase_if(numbers, [](const Found& one) { return one.isFrequency(); });
    return onlyOne(numbers).and_then([&](double value) -> Result<double> {
        if (!numbers.front().unit.isEmpty()) {
            return failure(ErrorCode::InvalidInput, Text::tr("its unit is not dB"));
        }
        return value;
    });
}

}  // namespace boresight::power

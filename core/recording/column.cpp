// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/column.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

namespace boresight::recording {
namespace {

// The first byte of a column. With kSomeUnknown a bit for each row follows: 1 means that the row has a value.
constexpr std::uint8_t kUnknown = 0;  // in all rows
constexpr std::uint8_t kConstant = 1;
constexpr std::uint8_t kFirstDifferences = 2;
constexpr std::uint8_t kSecondDifferences = 3;
constexpr std::uint8_t kSomeUnknown = 0x80;

using Numbers = std::vector<std::uint64_t>;  // differences of any two numbers fit, modulo 2^64

std::int64_t asSigned(std::uint64_t value)
{
    return std::bit_cast<std::int64_t>(value);
}

// Each number minus the one before it. The first number stays.
Numbers differences(const Numbers& numbers, std::size_t from)
{
    Numbers result = numbers;
    for (std::size_t i = numbers.size(); i-- > from;) {
        result[i] -= numbers[i - 1];
    }
    return result;
}

void sumUp(Numbers& numbers, std::size_t from)
{
    for (std::size_t i = from; i < numbers.size(); ++i) {
        numbers[i] += numbers[i - 1];
    }
}

void appendGroup(QByteArray& bytes, std::span<const std::uint64_t> group)
{
    const std::int64_t least = asSigned(*std::ranges::min_element(group, {}, asSigned));
    const std::int64_t most = asSigned(*std::ranges::max_element(group, {}, asSigned));
    const auto base = static_cast<std::uint64_t>(least);
    const auto width = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(most) - base));
    appendSigned(bytes, least);
    bytes.append(static_cast<char>(width));
    std::uint8_t byte = 0;
    unsigned filled = 0;
    for (const std::uint64_t number : group) {
        for (unsigned bit = 0; bit < width; ++bit) {
            byte |= static_cast<std::uint8_t>((((number - base) >> bit) & 1U) << filled);
            if (++filled == 8) {
                bytes.append(static_cast<char>(std::exchange(byte, std::uint8_t{0})));
                filled = 0;
            }
        }
    }
    if (filled > 0) {
        bytes.append(static_cast<char>(byte));
    }
}

[[nodiscard]] bool takeGroup(ByteSource& source, std::span<std::uint64_t> group)
{
    const auto least = source.signedVarint();
    const auto width = source.byte();
    if (!least || !width || *width > 64) {
        return false;
    }
    const auto packed = source.bytes((group.size() * *width + 7) / 8);
    if (!packed) {
        return false;
    }
    std::size_t at = 0;  // in bits
    for (std::uint64_t& number : group) {
        std::uint64_t above = 0;
        for (unsigned bit = 0; bit < *width; ++bit, ++at) {
            const auto byte = static_cast<std::uint8_t>((*packed)[static_cast<qsizetype>(at / 8)]);
            above |= std::uint64_t{(byte >> (at % 8)) & 1U} << bit;
        }
        number = static_cast<std::uint64_t>(*least) + above;
    }
    return true;
}

// The first numbers as they are, the others in groups.
QByteArray packed(const Numbers& numbers, std::size_t plain)
{
    QByteArray bytes;
    for (std::size_t i = 0; i < plain; ++i) {
        appendSigned(bytes, asSigned(numbers[i]));
    }
    for (std::size_t i = plain; i < numbers.size(); i += kGroup) {
        appendGroup(bytes, std::span(numbers).subspan(i, std::min(kGroup, numbers.size() - i)));
    }
    return bytes;
}

[[nodiscard]] bool unpack(ByteSource& source, Numbers& numbers, std::size_t plain)
{
    for (std::size_t i = 0; i < plain; ++i) {
        const auto number = source.signedVarint();
        if (!number) {
            return false;
        }
        numbers[i] = static_cast<std::uint64_t>(*number);
    }
    for (std::size_t i = plain; i < numbers.size(); i += kGroup) {
        if (!takeGroup(source, std::span(numbers).subspan(i, std::min(kGroup, numbers.size() - i)))) {
            return false;
        }
    }
    return true;
}

std::pair<std::uint8_t, QByteArray> shortest(const Numbers& numbers)
{
    if (std::ranges::all_of(numbers, [&](std::uint64_t one) { return one == numbers.front(); })) {
        return {kConstant, packed({numbers.front()}, 1)};
    }
    const Numbers first = differences(numbers, 1);
    QByteArray byFirst = packed(first, 1);
    QByteArray bySecond = packed(differences(first, 2), 2);  // at least two numbers: a single one is constant
    return bySecond.size() < byFirst.size() ? std::pair(kSecondDifferences, std::move(bySecond))
                                            : std::pair(kFirstDifferences, std::move(byFirst));
}

std::optional<Numbers> takeNumbers(ByteSource& source, std::uint8_t kind, std::size_t count)
{
    Numbers numbers(count);
    const std::size_t plain = kind == kSecondDifferences ? 2 : 1;
    if (kind == kConstant) {
        const auto value = source.signedVarint();
        std::ranges::fill(numbers, static_cast<std::uint64_t>(value.value_or(0)));
        return value ? std::optional(numbers) : std::nullopt;
    }
    const bool isKnown = kind == kFirstDifferences || kind == kSecondDifferences;
    if (!isKnown || count < plain || !unpack(source, numbers, plain)) {
        return std::nullopt;
    }
    if (kind == kSecondDifferences) {
        sumUp(numbers, 2);
    }
    sumUp(numbers, 1);
    return numbers;
}

}  // namespace

void appendColumn(QByteArray& bytes, const Column& column)
{
    Numbers numbers;
    for (const auto& value : column) {
        if (value) {
            numbers.push_back(static_cast<std::uint64_t>(*value));
        }
    }
    if (numbers.empty()) {
        bytes.append(static_cast<char>(kUnknown));
        return;
    }
    const auto [kind, packedNumbers] = shortest(numbers);
    if (numbers.size() == column.size()) {
        bytes.append(static_cast<char>(kind));
    } else {
        bytes.append(static_cast<char>(kind | kSomeUnknown));
        QByteArray known(static_cast<qsizetype>((column.size() + 7) / 8), '\0');
        for (std::size_t i = 0; i < column.size(); ++i) {
            if (column[i]) {
                char& byte = known[static_cast<qsizetype>(i / 8)];
                byte = static_cast<char>(static_cast<std::uint8_t>(byte) | (1U << (i % 8)));
            }
        }
        bytes.append(known);
    }
    bytes.append(packedNumbers);
}

std::optional<Column> takeColumn(ByteSource& source, std::size_t rows)
{
    const auto kind = source.byte();
    Column column(rows);
    if (!kind || *kind == kUnknown) {
        return kind ? std::optional(column) : std::nullopt;
    }
    std::vector<bool> isKnown(rows, true);
    if ((*kind & kSomeUnknown) != 0) {
        const auto bits = source.bytes((rows + 7) / 8);
        if (!bits) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < rows; ++i) {
            isKnown[i] = ((static_cast<std::uint8_t>((*bits)[static_cast<qsizetype>(i / 8)]) >> (i % 8)) & 1U) != 0;
        }
    }
    const auto count = static_cast<std::size_t>(std::ranges::count(isKnown, true));
    const auto numbers = takeNumbers(source, static_cast<std::uint8_t>(*kind & ~kSomeUnknown), count);
    if (!numbers) {
        return std::nullopt;
    }
    for (std::size_t i = 0, next = 0; i < rows; ++i) {
        if (isKnown[i]) {
            column[i] = asSigned((*numbers)[next++]);
        }
    }
    return column;
}

}  // namespace boresight::recording

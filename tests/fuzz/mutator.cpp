// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::fuzz {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kMaxKept = 256;
constexpr int kMaxMutations = 16;
constexpr unsigned kRepaired = 85;  // percent

// Numbers that often cause errors in readers.
constexpr std::array kNumbers{
    "0"sv,
    "-0"sv,
    "1"sv,
    "-1"sv,
    "+1"sv,
    "--1"sv,
    "+-1"sv,
    "0.5"sv,
    ".5"sv,
    "5."sv,
    "1e-9"sv,
    "1e308"sv,
    "-1e308"sv,
    "1e309"sv,
    "1e-320"sv,
    "1e99999"sv,
    "nan"sv,
    "inf"sv,
    "-inf"sv,
    "infinity"sv,
    "0x10"sv,
    "0x1p4"sv,
    "010"sv,
    "1_000"sv,
    "127"sv,
    "128"sv,
    "255"sv,
    "256"sv,
    "32768"sv,
    "65535"sv,
    "65536"sv,
    "2147483647"sv,
    "2147483648"sv,
    "-2147483649"sv,
    "4294967296"sv,
    "9223372036854775807"sv,
    "1e"sv,
    "1,5"sv,
    "90"sv,
    "180"sv,
    "360"sv,
    "-180.00000000000001"sv,
    "89.9999999999999"sv,
    "0.1234567890123456789"sv,
    "18446744073709551616"sv,
    "-9223372036854775808"sv,
};

bool isNumberByte(char byte)
{
    return (byte >= '0' && byte <= '9') || byte == '.' || byte == '-' || byte == '+';
}

}  // namespace

Mutator::Mutator(Grammar grammar, std::uint64_t seed) : m_grammar(std::move(grammar)), m_random(seed) {}

// The small bias of the remainder does no harm here. Unlike std::uniform_int_distribution the result is the same with
// every library.
std::size_t Mutator::below(std::size_t count)
{
    return count == 0 ? 0 : m_random() % count;
}

std::string Mutator::next()
{
    std::string text = anyValid();
    int mutations = 0;
    do {
        mutate(text);
    } while (++mutations < kMaxMutations && percent(m_grammar.persistence));
    text.resize(std::min(text.size(), m_grammar.maxLength));
    if (m_grammar.repair && percent(kRepaired)) {
        m_grammar.repair(text);
    }
    return text;
}

void Mutator::keep(const std::string& input)
{
    if (m_kept.size() < kMaxKept) {
        m_kept.push_back(input);
    } else {
        m_kept[below(kMaxKept)] = input;
    }
}

const std::string& Mutator::anyValid()
{
    const bool grown = !m_kept.empty() && percent(30);
    const std::vector<std::string>& from = grown ? m_kept : m_grammar.corpus;
    return from[below(from.size())];
}

const std::string& Mutator::anyToken()
{
    return m_grammar.tokens[below(m_grammar.tokens.size())];
}

Mutator::Part Mutator::anyPart(const std::string& text, std::size_t longest)
{
    const std::size_t start = below(text.size() + 1);
    return {start, std::min(text.size() - start, 1 + below(longest))};
}

// The word around a random place. Empty at a separator.
Mutator::Part Mutator::anyWord(const std::string& text)
{
    if (m_grammar.separators.empty()) {
        return anyPart(text, 4);
    }
    const std::size_t place = below(text.size());
    const std::size_t before = text.find_last_of(m_grammar.separators, place);
    const std::size_t start = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = std::min(text.find_first_of(m_grammar.separators, place), text.size());
    return {std::min(start, end), end - std::min(start, end)};
}

// The number after a random place, or nothing at that place.
Mutator::Part Mutator::anyNumber(const std::string& text)
{
    const std::size_t place = below(text.size());
    const auto from = text.begin() + static_cast<std::ptrdiff_t>(place);
    const auto start = std::find_if(from, text.end(), isNumberByte);
    const auto end = std::find_if_not(start, text.end(), isNumberByte);
    return {static_cast<std::size_t>(start - text.begin()), static_cast<std::size_t>(end - start)};
}

void Mutator::mutate(std::string& text)
{
    switch (below(3)) {
        case 0:
            return mutateBytes(text);
        case 1:
            return mutateWords(text);
        default:
            return mutateShape(text);
    }
}

void Mutator::mutateBytes(std::string& text)
{
    if (text.empty()) {
        return text.push_back(static_cast<char>(below(256)));
    }
    char& byte = text[below(text.size())];
    switch (below(4)) {
        case 0:
            byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(8)));
            return;
        case 1:
            byte = static_cast<char>(below(256));
            return;
        case 2: {  // a digit replaced by a digit keeps most texts valid
            const Part number = anyNumber(text);
            if (number.size > 0) {
                text[number.start + below(number.size)] = static_cast<char>('0' + below(10));
            }
            return;
        }
        default: {  // overwrites, so that lengths and offsets stay the same
            const std::string& token = anyToken();
            text.replace(below(text.size()), token.size(), token);
            return;
        }
    }
}

void Mutator::mutateWords(std::string& text)
{
    switch (below(4)) {
        case 0: {
            const Part word = anyWord(text);
            text.replace(word.start, word.size, anyToken());
            return;
        }
        case 1: {
            const std::string& token = anyToken();
            text.insert(below(text.size() + 1), token);
            return;
        }
        case 2: {
            const Part number = anyNumber(text);
            text.replace(number.start, number.size, kNumbers[below(kNumbers.size())]);
            return;
        }
        default:
            return exchangeWords(text);
    }
}

void Mutator::mutateShape(std::string& text)
{
    constexpr std::size_t kLongest = 64;
    const Part part = anyPart(text, kLongest);
    switch (below(5)) {
        case 0:
            text.erase(part.start, part.size);
            return;
        case 1: {
            const std::string piece = text.substr(part.start, part.size);
            for (std::size_t copies = 1 + below(percent(10) ? kLongest : 3); copies > 0; --copies) {
                text.insert(part.start, piece);
            }
            return;
        }
        case 2:
            text.resize(part.start);
            return;
        case 3: {
            const std::string& other = anyValid();
            const Part taken = anyPart(other, kLongest);
            text.replace(part.start, percent(50) ? part.size : 0, other, taken.start, taken.size);
            return;
        }
        default:
            text += anyValid();
            return;
    }
}

void Mutator::exchangeWords(std::string& text)
{
    Part first = anyWord(text);
    Part second = anyWord(text);
    if (second.start < first.start) {
        std::swap(first, second);
    }
    if (first.start + first.size > second.start) {
        return;  // both are the same
    }
    const std::string early = text.substr(first.start, first.size);
    const std::string late = text.substr(second.start, second.size);
    text.replace(second.start, second.size, early);
    text.replace(first.start, first.size, late);
}

}  // namespace boresight::fuzz

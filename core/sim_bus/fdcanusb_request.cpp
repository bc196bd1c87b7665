// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/fdcanusb_request.h"

#include "core/base/hex.h"
#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>
#include <vector>

namespace boresight::sim {
namespace {

constexpr std::uint32_t kLargestId = 0x1fffffff;
constexpr std::size_t kMostClassicData = 8;

using Refused = tl::unexpected<std::string>;

// Fields are separated by exactly one space. Two spaces enclose an empty field.
std::vector<std::string_view> fieldsOf(std::string_view line)
{
    std::vector<std::string_view> fields;
    for (std::size_t start = 0; start <= line.size();) {
        const std::size_t end = std::min(line.find(' ', start), line.size());
        fields.push_back(line.substr(start, end - start));
        start = end + 1;
    }
    return fields;
}

bool isHex(std::string_view text)
{
    return std::ranges::all_of(text, [](unsigned char c) { return std::isxdigit(c) != 0; });
}

std::optional<std::uint32_t> identifier(std::string_view text)
{
    const auto value = isHex(text) && text.size() <= 8 ? parseInteger(text, 16) : std::nullopt;
    return value && *value <= kLargestId ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

// Flags as letters in one or more words: upper case switches a flag on, lower case off. False for an unknown letter.
bool applyFlags(CanFrame& frame, std::string_view letters)
{
    for (const char letter : letters) {
        if (letter == 'B' || letter == 'b') {
            frame.bitRateSwitch = letter == 'B';
        } else if (letter == 'F' || letter == 'f') {
            frame.flexibleData = letter == 'F';
        } else if (letter != 'R' && letter != 'r') {  // remote frames mean nothing to a moteus
            return false;
        }
    }
    return true;
}

}  // namespace

tl::expected<CanFrame, std::string> parseSendRequest(std::string_view line)
{
    const std::vector<std::string_view> fields = fieldsOf(line);
    if (fields.size() < 4) {
        return Refused("insufficient options");
    }
    const std::optional<std::uint32_t> id = identifier(fields[2]);
    if (!id || (fields[1] == "std" && *id > kMaxStandardId)) {
        return Refused("bad id");
    }
    const std::string_view digits = fields[3];
    if (digits.empty() || digits.size() % 2 != 0 || digits.size() > 2 * kMaxCanPayload) {
        return Refused("data invalid length");
    }
    const auto data = parseHex(digits);
    if (!data) {
        return Refused("invalid data");
    }
    CanFrame frame{.id = *id, .extended = fields[1] == "ext" || *id > kMaxStandardId};
    for (std::size_t i = 4; i < fields.size(); ++i) {
        if (!applyFlags(frame, fields[i])) {
            return Refused("unknown flag");
        }
    }
    if (!frame.flexibleData && data->size() > kMostClassicData) {
        return Refused("data invalid length");
    }
    frame.bitRateSwitch = frame.bitRateSwitch && frame.flexibleData;
    frame.setPayload(*data);
    frame.size = static_cast<std::uint8_t>(legalCanLength(data->size()));
    return frame;
}

std::string receivedLine(const CanFrame& frame)
{
    std::array<char, 16> id{};
    const int digits = frame.id > 0xffffff ? 8 : frame.id > 0xffff ? 6 : frame.id > 0xff ? 4 : 2;
    std::snprintf(id.data(), id.size(), "%0*X", digits, static_cast<unsigned>(frame.id));
    return std::string("rcv ") + id.data() + " " + toHex(frame.payload(), HexCase::Upper) +
           (frame.extended ? " E" : " e") + (frame.bitRateSwitch ? " B" : " b") + (frame.flexibleData ? " F" : " f") +
           " r x-1";
}

}  // namespace boresight::sim

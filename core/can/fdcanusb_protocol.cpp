// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/fdcanusb_protocol.h"

#include "core/base/hex.h"
#include "core/base/numbers.h"
#include "core/can/bus_frame.h"
#include "core/can/line_checksum.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>
#include <vector>

namespace boresight::fdcanusb {
namespace {

// The adapter writes exactly one space between fields, so two spaces enclose an empty field.
std::vector<std::string_view> splitAtSpaces(std::string_view line)
{
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t space = line.find(' ');
        words.push_back(line.substr(0, space));
        if (space == std::string_view::npos) {
            return words;
        }
        line.remove_prefix(space + 1);
    }
}

std::optional<std::uint32_t> parseId(std::string_view digits)
{
    constexpr std::size_t kMaxDigits = 8;
    const bool hex = std::ranges::all_of(digits, [](unsigned char c) { return std::isxdigit(c) != 0; });
    const auto value = hex && digits.size() <= kMaxDigits ? parseInteger(digits, 16) : std::nullopt;
    return value && *value <= kMaxExtendedId ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

struct Flags
{
    std::optional<bool> extended, bitRateSwitch, flexibleData, remote;
};

// Only single letters are flags. Older firmware adds words like "t1234" and "f00", and all firmware adds "x-1".
Flags parseFlags(std::span<const std::string_view> words)
{
    Flags flags;
    for (const std::string_view word : words) {
        if (word == "E" || word == "e") {
            flags.extended = word == "E";
        } else if (word == "B" || word == "b") {
            flags.bitRateSwitch = word == "B";
        } else if (word == "F" || word == "f") {
            flags.flexibleData = word == "F";
        } else if (word == "R" || word == "r") {
            flags.remote = word == "R";
        }
    }
    return flags;
}

// Reads the words of "rcv ID DATA FLAGS…". Missing flags (a moteus UART sends none) have the defaults of the adapter.
Answer parseReceived(std::span<const std::string_view> words)
{
    if (words.size() < 3) {
        return Unreadable{};
    }
    const auto id = parseId(words[1]);
    const auto data = parseHex(words[2]);
    const Flags flags = parseFlags(words.subspan(3));
    if (flags.remote.value_or(false)) {
        return RemoteFrame{};
    }
    // A length that no frame can have means that the line is damaged.
    if (!id || !data || data->size() > kMaxCanPayload || legalCanLength(data->size()) != data->size()) {
        return Unreadable{};
    }
    CanFrame frame;
    frame.id = *id;
    frame.extended = flags.extended.value_or(*id > kMaxStandardId);
    frame.flexibleData = flags.flexibleData.value_or(true);
    frame.bitRateSwitch = frame.flexibleData && flags.bitRateSwitch.value_or(true);
    frame.setPayload(*data);
    const bool idTooLong = !frame.extended && frame.id > kMaxStandardId;
    const bool dataTooLong = !frame.flexibleData && frame.size > kMaxClassicPayload;
    return idTooLong || dataTooLong ? Answer(Unreadable{}) : Answer(frame);
}

Answer parseBusStatus(std::span<const std::string_view> words)
{
    const auto holds = [words](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    if (holds("busoff=1") == holds("busoff=0")) {
        return Unreadable{};
    }
    return BusStatus{.busOff = holds("busoff=1"), .errorPassive = holds("err=1")};
}

}  // namespace

Result<std::string> sendLine(const CanFrame& frame)
{
    Result<CanFrame> ready = readyForBus(frame);
    if (!ready) {
        return tl::unexpected(ready.error());
    }
    if (ready->size == 0) {
        ready->setPayload(std::array{kPaddingByte});
    }
    // "send" chooses the type of the identifier by its value. Only a short extended identifier needs "ext".
    const char* const command = ready->extended && ready->id <= kMaxStandardId ? "ext" : "send";
    std::array<char, 32> head{};
    std::snprintf(head.data(), head.size(), "can %s %04x ", command, static_cast<unsigned>(ready->id));
    return head.data() + toHex(ready->payload()) + (ready->bitRateSwitch ? " B" : " b") +
           (ready->flexibleData ? "F" : "f");
}

Answer parseAnswer(std::string_view line, ChecksumRule rule)
{
    const CheckedLine checked = splitChecksum(line);
    const bool missing = checked.checksum == Checksum::Absent && rule == ChecksumRule::Require;
    if (missing || checked.checksum == Checksum::Wrong) {
        return Unreadable{};
    }
    if (checked.text == "OK") {
        return Accepted{};
    }
    const std::vector<std::string_view> words = splitAtSpaces(checked.text);
    if (words.front() == "rcv") {
        return parseReceived(words);
    }
    if (words.front() == "ERR") {
        const std::size_t textStart = std::min(checked.text.size(), words.front().size() + 1);
        return Refusal{std::string(checked.text.substr(textStart))};
    }
    if (words.front().starts_with("lec=")) {
        return parseBusStatus(words);
    }
    return Unreadable{};
}

}  // namespace boresight::fdcanusb

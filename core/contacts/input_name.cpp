// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/input_name.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/contacts/place_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::contacts {
namespace {

constexpr std::array kInputKinds{std::pair{"moteus:", InputKind::Pin}, std::pair{"mqtt:", InputKind::Mqtt},
                                 std::pair{"cts:", InputKind::Cts},    std::pair{"dsr:", InputKind::Dsr},
                                 std::pair{"dcd:", InputKind::Dcd},    std::pair{"ri:", InputKind::Ri}};

constexpr std::size_t kLongestContact = 20;  // bytes
constexpr std::int64_t kHighestBoard = 126;
constexpr std::int64_t kHighestPin = 4;

// "1:aux1.0"
Result<BoardPin> parsePin(std::string_view text)
{
    constexpr std::string_view kPort = ":aux";
    const std::size_t colon = text.find(kPort);
    const std::size_t dot = text.rfind('.');
    const bool isPin = colon != std::string_view::npos && dot != std::string_view::npos && dot > colon + kPort.size();
    const auto number = [&](std::size_t from, std::size_t to) {
        return isPin ? parseInteger(text.substr(from, to - from)) : std::nullopt;
    };
    const auto board = number(0, colon);
    const auto port = isPin ? number(colon + kPort.size(), dot) : std::nullopt;
    const auto pin = isPin ? number(dot + 1, text.size()) : std::nullopt;
    if (!board || !port || !pin || *board < 1 || *board > kHighestBoard || *port < 1 || *port > 2 || *pin < 0 ||
        *pin > kHighestPin) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the id of a board and a pin are expected, like moteus:1:aux1.0. The ports are aux1 "
                                "and aux2, the pins 0 to 4"));
    }
    return BoardPin{
        .board = static_cast<int>(*board), .port = static_cast<int>(*port), .number = static_cast<int>(*pin)};
}

char lowered(char letter)
{
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

Result<InputName> parseInput(const std::string& text)
{
    if (text.empty()) {
        return InputName{};
    }
    if (const Result<> line = checkLine(text); !line) {
        return tl::unexpected(line.error());
    }
    const auto* const found =
        std::ranges::find_if(kInputKinds, [&](const auto& one) { return text.starts_with(one.first); });
    if (found == kInputKinds.end()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("moteus:ID:aux1.PIN, mqtt:TOPIC, cts:PORT, dsr:PORT, dcd:PORT or ri:PORT is expected"));
    }
    const InputKind kind = found->second;
    const std::string_view place = std::string_view(text).substr(std::string_view(found->first).size());
    if (kind == InputKind::Pin) {
        return parsePin(place).map([&](const BoardPin& pin) { return InputName{.kind = kind, .pin = pin}; });
    }
    return (kind == InputKind::Mqtt ? checkedTopic(toQString(place)) : checkedPath(toQString(place)))
        .map([&](const QString& checked) { return InputName{.kind = kind, .place = checked}; });
}

Result<bool> readContact(std::string_view message)
{
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t begin = std::min(message.find_first_not_of(kSpace), message.size());
    const std::size_t end = message.find_last_not_of(kSpace);
    const std::string_view trimmed =
        begin < message.size() ? message.substr(begin, end - begin + 1) : std::string_view();
    if (trimmed.size() <= kLongestContact) {
        std::string word(trimmed);
        std::ranges::transform(word, word.begin(), lowered);
        if (word == "on" || word == "1" || word == "true") {
            return true;
        }
        if (word == "off" || word == "0" || word == "false") {
            return false;
        }
    }
    return failure(ErrorCode::InvalidInput, Text::tr("on or off is expected"));
}

}  // namespace boresight::contacts

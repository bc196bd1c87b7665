// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/board_pin.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight::contacts {
namespace {

constexpr std::int64_t kHighestBoard = 126;
constexpr std::int64_t kHighestPin = 4;

}  // namespace

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

}  // namespace boresight::contacts

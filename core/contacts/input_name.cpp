// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contacts/input_name.h"

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

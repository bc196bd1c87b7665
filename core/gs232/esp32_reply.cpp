// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_reply.h"

#include "core/base/numbers.h"

namespace boresight::gs232::esp32 {
namespace {

constexpr double kMostTilt = 270.0;  // more than any sensor reports

// Exactly one decimal, as the box writes its angles.
std::optional<Angle> oneDecimal(std::string_view text)
{
    const auto point = text.find('.');
    const auto degrees = point != std::string_view::npos && point + 2 == text.size() ? parseFinite(text) : std::nullopt;
    return degrees ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
}

// "123.4 45.6"
std::optional<Place> placeOf(std::string_view line)
{
    const auto blank = line.find(' ');
    if (blank == std::string_view::npos) {
        return std::nullopt;
    }
    const auto azimuth = oneDecimal(line.substr(0, blank));
    const auto elevation = oneDecimal(line.substr(blank + 1));
    const bool isPossible = azimuth && elevation && azimuth->degrees() >= 0.0 && azimuth->degrees() <= 360.0 &&
                            abs(*elevation).degrees() <= kMostTilt;
    return isPossible ? std::optional(Place{.azimuth = *azimuth, .elevation = *elevation}) : std::nullopt;
}

std::optional<int> digitAfter(std::string_view line, std::string_view name)
{
    const auto at = line.find(name);
    const auto digit = at == std::string_view::npos ? at : at + name.size();
    const bool isDigit = digit < line.size() && line[digit] >= '0' && line[digit] <= '3';
    return isDigit ? std::optional(line[digit] - '0') : std::nullopt;
}

std::optional<Digits> digitsOf(std::string_view line, const std::array<std::string_view, 4>& names, bool blocks)
{
    std::array<int, 4> values{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto value = digitAfter(line, names[i]);
        if (!value) {
            return std::nullopt;
        }
        values[i] = *value;
    }
    return Digits{.system = values[0],
                  .gyroscope = values[1],
                  .accelerometer = values[2],
                  .magnetometer = values[3],
                  .blocks = blocks};
}

std::optional<Digits> digitsOf(std::string_view line)
{
    if (line.starts_with("CALIB: ")) {
        return digitsOf(line, {"SYS=", "GYR=", "ACC=", "MAG="}, true);
    }
    return line.starts_with("DEBUG | ") ? digitsOf(line, {"Calib[S:", " G:", " A:", " M:"}, false) : std::nullopt;
}

}  // namespace

Reply parseLine(std::string_view line)
{
    if (line == "RPRT 0" || line == "RPRT -1") {
        return Code{.accepted = line == "RPRT 0"};
    }
    if (line.starts_with("VEAdamESP32")) {
        return Version{};
    }
    if (line.starts_with("Ready! ")) {
        return Started{};
    }
    if (line == "DEBUG ON" || line == "DEBUG OFF") {
        return Debugs{.on = line == "DEBUG ON"};
    }
    if (const auto digits = digitsOf(line)) {
        return *digits;
    }
    const auto place = placeOf(line);
    return place ? Reply(*place) : Reply(Unread{});
}

bool isLineOfEsp32(std::string_view line)
{
    const Reply reply = parseLine(line);
    return !std::holds_alternative<Place>(reply) && !std::holds_alternative<Unread>(reply);
}

}  // namespace boresight::gs232::esp32

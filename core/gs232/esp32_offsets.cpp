// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_offsets.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <span>

namespace boresight::gs232::esp32 {
namespace {

constexpr int kMostOffset = 32767;  // 16 bits

// As many whole numbers as `into` has, separated by blanks and one `separator` each. Nothing else. Another text changes
// nothing.
bool readNumbers(std::string_view text, char separator, std::span<int> into)
{
    std::array<int, 3> numbers{};
    const auto skipBlanks = [&text] { text.remove_prefix(std::min(text.find_first_not_of(' '), text.size())); };
    for (std::size_t i = 0; i < into.size(); ++i) {
        skipBlanks();
        if (i > 0 && separator != ' ') {
            if (!text.starts_with(separator)) {
                return false;
            }
            text.remove_prefix(1);
            skipBlanks();
        }
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
        if (error != std::errc{} || std::abs(numbers[i]) > kMostOffset) {
            return false;
        }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    skipBlanks();
    if (!text.empty()) {
        return false;
    }
    std::copy_n(numbers.begin(), into.size(), into.begin());
    return true;
}

std::string joined(const std::array<int, 3>& values)
{
    return std::to_string(values[0]) + ' ' + std::to_string(values[1]) + ' ' + std::to_string(values[2]);
}

bool areNear(const std::array<int, 3>& one, const std::array<int, 3>& other, int tolerance)
{
    return std::ranges::equal(one, other, [tolerance](int a, int b) { return std::abs(a - b) <= tolerance; });
}

// The rest of the text after `name`, up to the next comma, which is removed. Empty: `text` does not begin with it.
std::optional<std::string_view> takePart(std::string_view& text, std::string_view name)
{
    if (!text.starts_with(name)) {
        return std::nullopt;
    }
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view part = text.substr(name.size(), comma - name.size());
    text.remove_prefix(std::min(comma + 1, text.size()));
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return part;
}

}  // namespace

std::string offsetsText(const Offsets& offsets)
{
    return "accelerometer " + joined(offsets.accelerometer) + ", magnetometer " + joined(offsets.magnetometer) +
           ", gyroscope " + joined(offsets.gyroscope) + ", radii " + std::to_string(offsets.accelerometerRadius) + ' ' +
           std::to_string(offsets.magnetometerRadius);
}

std::optional<Offsets> parseOffsets(std::string_view text)
{
    Offsets offsets;
    std::array<int, 2> radii{};
    const auto take = [&text](std::string_view name, std::span<int> into) {
        const auto part = takePart(text, name);
        return part && readNumbers(*part, ' ', into);
    };
    if (!take("accelerometer ", offsets.accelerometer) || !take("magnetometer ", offsets.magnetometer) ||
        !take("gyroscope ", offsets.gyroscope) || !take("radii ", radii) || !text.empty()) {
        return std::nullopt;
    }
    offsets.accelerometerRadius = radii[0];
    offsets.magnetometerRadius = radii[1];
    return offsets;
}

bool areAlike(const Offsets& one, const Offsets& other)
{
    constexpr int kTilt = 35;
    constexpr int kHeading = 11;
    constexpr int kTurn = 16;
    return areNear(one.accelerometer, other.accelerometer, kTilt) &&
           areNear(one.magnetometer, other.magnetometer, kHeading) && areNear(one.gyroscope, other.gyroscope, kTurn);
}

bool OffsetLines::take(std::string_view line)
{
    const auto part = [&](std::string_view name, std::span<int> into, unsigned bit) {
        const bool isIt = line.starts_with(name) && readNumbers(line.substr(name.size()), ',', into);
        m_received |= isIt ? bit : 0;
        return isIt;
    };
    return part("Accel Off:", m_offsets.accelerometer, 0b1) || part("Mag   Off:", m_offsets.magnetometer, 0b10) ||
           part("Gyro  Off:", m_offsets.gyroscope, 0b100) ||
           part("Accel Rad:", std::span(&m_offsets.accelerometerRadius, 1), 0b1000) ||
           part("Mag   Rad:", std::span(&m_offsets.magnetometerRadius, 1), 0b10000);
}

std::optional<Offsets> OffsetLines::offsets() const
{
    return m_received == kAll ? std::optional(m_offsets) : std::nullopt;
}

}  // namespace boresight::gs232::esp32

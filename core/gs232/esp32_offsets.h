// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The offsets by which the sensor of the ESP32 relay controller corrects its readings. The box stores them when it
// calibrates. No command of the box writes them. Pure.
namespace boresight::gs232::esp32 {

// In the units of the sensor: 1 mg, 1/16 µT, 1/16 °/s.
struct Offsets
{
    std::array<int, 3> accelerometer{};
    std::array<int, 3> magnetometer{};
    std::array<int, 3> gyroscope{};
    int accelerometerRadius = 0;
    int magnetometerRadius = 0;

    bool operator==(const Offsets&) const = default;
};

// As the profile stores them: "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1000 700".
[[nodiscard]] std::string offsetsText(const Offsets& offsets);
// Empty for any other text.
[[nodiscard]] std::optional<Offsets> parseOffsets(std::string_view text);

// Whether both give the same angles within 2°, which is the tolerance of the box. The sensor changes its offsets a
// little while it works. A tilt of 2° is 35 mg. A heading of 2° is 0.7 µT in a horizontal field of 20 µT. A turn of
// 1 °/s is a drift.
[[nodiscard]] bool areAlike(const Offsets& one, const Offsets& other);

// Puts the lines of one answer together.
class OffsetLines
{
public:
    // False if the line is not about offsets.
    bool take(std::string_view line);
    void forget() { *this = {}; }
    // Empty until all of the lines were received.
    [[nodiscard]] std::optional<Offsets> offsets() const;

private:
    static constexpr unsigned kAll = 0b11111;

    Offsets m_offsets;
    unsigned m_received = 0;  // one bit for each line
};

}  // namespace boresight::gs232::esp32

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// The optional checksum at the end of an fdcanusb line, " *XX": CRC-8 with polynomial 0x97, start value 0, not
// reflected, over everything before the '*' including the space. Both sides of the protocol use it. Pure.
namespace boresight::fdcanusb {

[[nodiscard]] std::uint8_t crc8(std::string_view text);

// "OK" becomes "OK *BD".
[[nodiscard]] std::string withChecksum(std::string_view line);

enum class Checksum
{
    Absent,
    Right,
    Wrong,  // does not match, or the text after '*' is not two hexadecimal digits
};

struct CheckedLine
{
    std::string_view text;  // the line without its checksum and the space before it
    Checksum checksum = Checksum::Absent;
};

[[nodiscard]] CheckedLine splitChecksum(std::string_view line);

}  // namespace boresight::fdcanusb

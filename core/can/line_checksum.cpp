// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/line_checksum.h"

#include "core/base/hex.h"

#include <array>

namespace boresight::fdcanusb {

std::uint8_t crc8(std::string_view text)
{
    constexpr unsigned kPolynomial = 0x97;
    unsigned crc = 0;
    for (const char character : text) {
        crc ^= static_cast<unsigned char>(character);
        for (int bit = 0; bit < 8; ++bit) {
            crc = ((crc & 0x80U) != 0 ? (crc << 1U) ^ kPolynomial : crc << 1U) & 0xffU;
        }
    }
    return static_cast<std::uint8_t>(crc);
}

std::string withChecksum(std::string_view line)
{
    std::string text(line);
    text += ' ';
    const std::array<std::uint8_t, 1> crc{crc8(text)};
    return text + '*' + toHex(crc, HexCase::Upper);
}

CheckedLine splitChecksum(std::string_view line)
{
    const std::size_t star = line.rfind('*');
    if (star == std::string_view::npos) {
        return {line, Checksum::Absent};
    }
    const std::string_view covered = line.substr(0, star);
    const auto crc = parseHex(line.substr(star + 1));
    const bool right = crc && crc->size() == 1 && crc->front() == crc8(covered);
    const std::string_view text = covered.ends_with(' ') ? covered.substr(0, covered.size() - 1) : covered;
    return {text, right ? Checksum::Right : Checksum::Wrong};
}

}  // namespace boresight::fdcanusb

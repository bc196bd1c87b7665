// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstdint>
#include <optional>

// A block of a recording: the marker, its kind, its length, its content and a CRC-32 of these. A block is readable
// without the others. Pure.
namespace boresight::recording {

inline constexpr QByteArrayView kBlockMarker =
    "\xB5"
    "BLK";
inline constexpr qsizetype kBlockFrame = 4 + 1 + 4 + 4;  // marker, kind, length, CRC

// The kinds of this version. A reader passes over others.
inline constexpr char kHeaderBlock = 'H';
inline constexpr char kTickBlock = 'T';
inline constexpr char kEventBlock = 'E';
inline constexpr char kPlanBlock = 'P';
inline constexpr char kGapBlock = 'G';
inline constexpr char kEndBlock = 'Z';

// More than in any block that Boresight writes.
inline constexpr qsizetype kMostContent = 16'000'000;

struct Block
{
    char kind = 0;
    QByteArrayView content;

    [[nodiscard]] qsizetype size() const { return kBlockFrame + content.size(); }  // in the file
};

// The CRC-32 of Ethernet, zip and PNG: reflected polynomial 0xEDB88320.
[[nodiscard]] std::uint32_t crc32(QByteArrayView bytes);

[[nodiscard]] QByteArray blockBytes(char kind, QByteArrayView content);

// The bytes that the CRC of a block at the beginning of these bytes covers. 0: its marker or its length are wrong, or
// it is cut.
[[nodiscard]] qsizetype coveredBytes(QByteArrayView bytes);

// The block at the beginning of these bytes. Empty: there is none, or it is damaged or cut.
[[nodiscard]] std::optional<Block> blockAt(QByteArrayView bytes);

}  // namespace boresight::recording

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/block.h"

#include <QtEndian>

#include <algorithm>
#include <array>

namespace boresight::recording {
namespace {

constexpr qsizetype kLengthAt = 5;
constexpr qsizetype kContentAt = 9;
constexpr qsizetype kCrcBytes = 4;

constexpr std::array<std::uint32_t, 256> kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) {
            value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        table[i] = value;
    }
    return table;
}();

QByteArray littleEndian(std::uint32_t value)
{
    QByteArray bytes(sizeof value, Qt::Uninitialized);
    qToLittleEndian(value, bytes.data());
    return bytes;
}

}  // namespace

std::uint32_t crc32(QByteArrayView bytes)
{
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        value = (value >> 8U) ^ kCrcTable[(value ^ static_cast<std::uint8_t>(byte)) & 0xFFU];
    }
    return ~value;
}

QByteArray blockBytes(char kind, QByteArrayView content)
{
    QByteArray bytes = kBlockMarker.toByteArray();
    bytes.append(kind);
    bytes.append(littleEndian(static_cast<std::uint32_t>(content.size())));
    bytes.append(content);
    bytes.append(littleEndian(crc32(bytes)));
    return bytes;
}

qsizetype coveredBytes(QByteArrayView bytes)
{
    if (bytes.size() < kBlockFrame || !bytes.startsWith(kBlockMarker)) {
        return 0;
    }
    const auto length = qsizetype{qFromLittleEndian<std::uint32_t>(bytes.data() + kLengthAt)};
    return length <= std::min(kMostContent, bytes.size() - kBlockFrame) ? kContentAt + length : 0;
}

std::optional<Block> blockAt(QByteArrayView bytes)
{
    const QByteArrayView covered = bytes.first(coveredBytes(bytes));
    if (covered.isEmpty()) {
        return std::nullopt;
    }
    const auto written = qFromLittleEndian<std::uint32_t>(bytes.data() + covered.size());
    static_assert(kContentAt + kCrcBytes == kBlockFrame);
    if (written != crc32(covered)) {
        return std::nullopt;
    }
    return Block{.kind = bytes[kBlockMarker.size()], .content = covered.sliced(kContentAt)};
}

}  // namespace boresight::recording

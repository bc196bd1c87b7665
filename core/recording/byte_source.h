// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <bit>
#include <cstdint>
#include <optional>

// The numbers of a recording as bytes. A varint has 7 bits in each byte, lowest first. The top bit means that another
// byte follows. A signed number is zigzag: 0, -1, 1, -2 are 0, 1, 2, 3. Pure.
namespace boresight::recording {

inline void appendVarint(QByteArray& bytes, std::uint64_t value)
{
    for (; value >= 0x80U; value >>= 7U) {
        bytes.append(static_cast<char>((value & 0x7fU) | 0x80U));
    }
    bytes.append(static_cast<char>(value));
}

inline void appendSigned(QByteArray& bytes, std::int64_t value)
{
    appendVarint(bytes, (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63));
}

// Reads from the beginning. Empty: there are too few bytes, or they are no such number.
class ByteSource
{
public:
    explicit ByteSource(QByteArrayView bytes) : m_rest(bytes) {}

    [[nodiscard]] bool atEnd() const { return m_rest.isEmpty(); }
    [[nodiscard]] std::optional<std::uint8_t> byte()
    {
        if (m_rest.isEmpty()) {
            return std::nullopt;
        }
        const auto value = static_cast<std::uint8_t>(m_rest.front());
        m_rest = m_rest.sliced(1);
        return value;
    }
    [[nodiscard]] std::optional<QByteArrayView> bytes(std::uint64_t count)
    {
        if (count > static_cast<std::uint64_t>(m_rest.size())) {
            return std::nullopt;
        }
        const QByteArrayView taken = m_rest.first(static_cast<qsizetype>(count));
        m_rest = m_rest.sliced(taken.size());
        return taken;
    }
    [[nodiscard]] std::optional<std::uint64_t> varint()
    {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto next = byte();
            if (!next) {
                return std::nullopt;
            }
            value |= (*next & std::uint64_t{0x7f}) << shift;
            if (*next < 0x80U) {
                return value;
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] std::optional<std::int64_t> signedVarint()
    {
        const auto value = varint();
        return value ? std::optional(std::bit_cast<std::int64_t>((*value >> 1U) ^ (0U - (*value & 1U)))) : std::nullopt;
    }

private:
    QByteArrayView m_rest;
};

}  // namespace boresight::recording

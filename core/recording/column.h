// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/byte_source.h"

#include <QByteArray>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The values of one channel in one block, as few bytes: differences of whole numbers, packed in groups of kGroup with
// the bits that the largest difference of the group needs. The bytes: README.md. Pure.
namespace boresight::recording {

using Column = std::vector<std::optional<std::int64_t>>;  // by tick; empty: unknown

inline constexpr std::size_t kGroup = 32;

void appendColumn(QByteArray& bytes, const Column& column);
// Empty: the bytes are not a column of so many rows.
[[nodiscard]] std::optional<Column> takeColumn(ByteSource& source, std::size_t rows);

}  // namespace boresight::recording

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// The self-describing records of the diagnostic console. A list of named values becomes a binary schema, binary data in
// the same order, or lines of text. Pure. A dot in a name begins an inner object.
namespace boresight::sim {

struct ArchiveUnsigned
{
    std::uint64_t value = 0;
    std::uint8_t width = 4;  // bytes
};

struct ArchiveSigned
{
    std::int64_t value = 0;
    std::uint8_t width = 4;
};

struct ArchiveEnum
{
    std::uint32_t value = 0;
    std::span<const std::string_view> names;  // names of the values 0, 1, 2, …; may be empty
};

struct ArchiveArray
{
    std::vector<std::uint32_t> values;
    std::uint8_t width = 4;
};

using ArchiveValue = std::variant<bool, ArchiveUnsigned, ArchiveSigned, float, ArchiveEnum, ArchiveArray>;

struct ArchiveField
{
    std::string name;
    ArchiveValue value;
};

[[nodiscard]] std::string binarySchema(std::span<const ArchiveField> fields);
[[nodiscard]] std::string binaryData(std::span<const ArchiveField> fields);
// Lines like "servo_stats.bus_V 24.012000", each with CR LF at its end.
[[nodiscard]] std::string textLines(std::string_view name, std::span<const ArchiveField> fields);

}  // namespace boresight::sim

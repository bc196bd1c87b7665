// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The block between META_START and META_STOP of an OEM, which describes the rows after it. Pure.
namespace boresight::tables {

struct OemEntry
{
    std::string_view key;
    std::string_view value;
};

// Parses "KEY = value". Empty for any other text.
[[nodiscard]] std::optional<OemEntry> oemEntry(std::string_view line);

class OemMeta
{
public:
    // Refused if the line is no entry, if its key does not belong into such a block, or if the key occurs again.
    Result<> take(std::string_view line);

    // Empty if the block does not have the key.
    [[nodiscard]] std::string_view value(std::string_view key) const;
    // Call it only if segment() succeeded.
    [[nodiscard]] TimeSystem timeSystem() const;
    // The segment without rows. The usable times are those of the block, or unlimited. Refused with the reason if an
    // entry is missing or not supported.
    [[nodiscard]] Result<OrbitSegment> segment() const;

private:
    static constexpr std::size_t kKeys = 12;

    [[nodiscard]] Result<OrbitFrame> frame() const;
    [[nodiscard]] Result<AtomicTime> time(std::string_view key, AtomicTime otherwise) const;
    [[nodiscard]] Result<> setDegree(OrbitSegment& segment) const;
    [[nodiscard]] Result<> isComplete() const;

    std::array<std::optional<std::string>, kKeys> m_values;
};

}  // namespace boresight::tables

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/tables/table.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The block between META_START and META_STOP of an OEM, and what it says of the rows behind it. Pure.
namespace boresight::tables {

struct OemEntry
{
    std::string_view key;
    std::string_view value;
};

// Of "KEY = value". Empty for all else.
[[nodiscard]] std::optional<OemEntry> oemEntry(std::string_view line);

class OemMeta
{
public:
    // Refused: it is no entry, no key of such a block, or there a second time.
    Result<> take(std::string_view line);

    // Empty: the block does not have it.
    [[nodiscard]] std::string_view value(std::string_view key) const;
    // Of a block for which segment() answers.
    [[nodiscard]] TimeSystem timeSystem() const;
    // Without rows. Usable from and to are those of the block, or as early and late as a time can be. Refused with the
    // reason: something is missing, or Boresight cannot do it.
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

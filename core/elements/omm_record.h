// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_list.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

// One orbit mean-elements message (CCSDS 502.0-B-3) in any format. The readers of JSON, CSV, XML and KVN store the
// texts of its fields by their keys. This class interprets them. The number of digits is not limited; catalogue numbers
// have up to 9. Pure.
namespace boresight::orbit {

class OmmRecord
{
public:
    // Keys that element sets do not need are ignored.
    void set(std::string_view key, std::string_view value, int line);
    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] bool isEmpty() const { return m_line == 0; }

    // A problem names the line of its field, or the first line of the record.
    [[nodiscard]] tl::expected<ElementSet, ElementProblem> elements() const;
    // Adds the element set or the problem to the list.
    void addTo(ElementList& list) const;

private:
    friend class OmmFields;
    struct Field
    {
        std::string value;
        int line = 0;
    };
    static constexpr std::size_t kFields = 21;

    std::array<std::optional<Field>, kFields> m_fields;
    int m_line = 0;
};

}  // namespace boresight::orbit

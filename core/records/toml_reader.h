// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/records/field_list.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Reads a record from TOML by the list of its fields (field_list.h). Strict: a key that is unknown, missing, of another
// type or out of range is an error, and its value stays unchanged. Pure.
namespace boresight::records {

struct TomlTable;  // hides toml++ from the files that include this one

class TomlReader
{
public:
    using Inner = std::function<void(TomlReader&)>;

    // Reports all errors together, one "FILE:LINE: KEY: REASON" per line.
    [[nodiscard]] static Result<> read(std::string_view text, const QString& fileName, const Inner& fields);

    [[nodiscard]] bool has(std::string_view key, bool) const;

    void number(std::string_view key, double& value, Range range);
    void whole(std::string_view key, std::int64_t& value, Range range);
    // The number of rows of a list that are in use. Must not exceed the number of rows.
    void countOf(std::string_view key, std::int64_t& value, std::string_view listKey);
    void text(std::string_view key, std::string& value);
    void text(std::string_view key, QString& value);
    void flag(std::string_view key, bool& value);
    void time(std::string_view key, UtcTime& value);

    // One of two names, in the order of the enumeration.
    template <class Choice>
    void choice(std::string_view key, Choice& value, std::span<const std::string_view, 2> names)
    {
        auto index = static_cast<std::size_t>(value);
        choiceIndex(key, index, names);
        value = static_cast<Choice>(index);
    }

    template <class Value, class Fields>
    void table(std::string_view key, Value& value, Fields fields)
    {
        inside(key, [&](TomlReader& reader) { fields(reader, value); });
    }

    // An absent list counts as empty.
    template <class Value, class Fields>
    void list(std::string_view key, std::vector<Value>& values, Fields fields)
    {
        each(key, [&](TomlReader& reader) { fields(reader, values.emplace_back()); });
    }

private:
    friend struct TomlTable;

    explicit TomlReader(TomlTable& table) : m_table(table) {}

    void choiceIndex(std::string_view key, std::size_t& index, std::span<const std::string_view, 2> names);
    void inside(std::string_view key, const Inner& fields);
    void each(std::string_view key, const Inner& fields);

    TomlTable& m_table;
};

}  // namespace boresight::records

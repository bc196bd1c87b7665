// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/control_characters.h"
#include "core/records/field_list.h"
#include "core/records/iso_time.h"
#include "core/records/toml_value.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Writes a record as TOML by the list of its fields (field_list.h). TOML requires simple keys before tables. Pure.
namespace boresight::records {

class TomlWriter
{
public:
    // An absent value is not written.
    [[nodiscard]] bool has(std::string_view, bool there) const { return there; }

    void number(std::string_view key, double value, Range) { line(key, decimal(value)); }
    void whole(std::string_view key, std::int64_t value, Range) { line(key, std::to_string(value)); }
    void countOf(std::string_view key, std::int64_t value, std::string_view) { line(key, std::to_string(value)); }
    void text(std::string_view key, const std::string& value) { line(key, inQuotes(printable(value))); }
    void text(std::string_view key, const QString& value) { text(key, value.toStdString()); }
    void flag(std::string_view key, bool value) { line(key, value ? "true" : "false"); }
    void time(std::string_view key, UtcTime value) { line(key, isoTime(value).toStdString()); }

    template <class Choice>
    void choice(std::string_view key, Choice value, std::span<const std::string_view, 2> names)
    {
        line(key, inQuotes(names[static_cast<std::size_t>(value)]));
    }

    template <class Value, class Fields>
    void table(std::string_view key, Value& value, Fields fields)
    {
        inside(key, "[", "]", value, fields);
    }

    template <class Value, class Fields>
    void list(std::string_view key, std::vector<Value>& values, Fields fields)
    {
        for (Value& value : values) {
            inside(key, "[[", "]]", value, fields);
        }
    }

    [[nodiscard]] const std::string& written() const { return m_text; }

private:
    void line(std::string_view key, const std::string& value) { m_text += std::string(key) + " = " + value + "\n"; }

    template <class Value, class Fields>
    void inside(std::string_view key, const char* open, const char* close, Value& value, Fields fields)
    {
        std::string path = (m_path.empty() ? "" : m_path + ".") + std::string(key);
        m_text += "\n" + (open + path) + close + "\n";
        const std::string outer = std::exchange(m_path, std::move(path));
        fields(*this, value);
        m_path = outer;
    }

    std::string m_path;
    std::string m_text;
};

}  // namespace boresight::records

// SPDX-License-Identifier: GPL-3.0-or-later
// Includes toml++, which is large and slow to compile.
#include "core/records/toml_reader.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/records/file_problems.h"

#include <toml++/toml.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace boresight::records {
namespace {

constexpr int kEarliest = 1970;
constexpr int kLatest = 2200;

UtcTime utcOf(const toml::date_time& time)
{
    const std::chrono::sys_days day{std::chrono::year(time.date.year) / time.date.month / time.date.day};
    return std::chrono::time_point_cast<UtcTime::duration>(
        day + std::chrono::hours(time.time.hour) + std::chrono::minutes(time.time.minute) +
        std::chrono::seconds(time.time.second) + std::chrono::nanoseconds(time.time.nanosecond));
}

}  // namespace

// One table of the file. Reports the keys that nobody has read.
struct TomlTable
{
    // Null if the key is missing. The missing key is reported.
    const toml::node* take(std::string_view key)
    {
        taken.emplace(key);
        const toml::node* node = toml.get(key);
        if (node == nullptr) {
            complainOfMissing(key);
        }
        return node;
    }

    void complainOfMissing(std::string_view key)
    {
        complain(pathOf(key), toml.source().begin.line, Text::tr("is missing"));
    }

    void complain(std::string_view key, const toml::node& node, const QString& reason)
    {
        complain(pathOf(key), node.source().begin.line, reason);
    }

    void complain(const std::string& whole, std::size_t line, const QString& reason)
    {
        problems.add(line, QStringLiteral("%1: %2").arg(toQString(whole), reason));
    }

    void read(const TomlReader::Inner& fields)
    {
        TomlReader reader(*this);
        fields(reader);
        for (const auto& [key, node] : toml) {
            if (!taken.contains(std::string(key.str()))) {
                complain(pathOf(key.str()), key.source().begin.line, Text::tr("unknown key"));
            }
        }
    }

    void readInner(const toml::node& node, const std::string& innerPath, const TomlReader::Inner& fields)
    {
        const toml::table* inner = node.as_table();
        if (inner == nullptr) {
            complain(innerPath, node.source().begin.line, Text::tr("a table is expected"));
            return;
        }
        TomlTable{*inner, innerPath, problems, {}}.read(fields);
    }

    [[nodiscard]] std::string pathOf(std::string_view key) const
    {
        return (path.empty() ? "" : path + ".") + std::string(key);
    }

    const toml::table& toml;
    std::string path;
    FileProblems& problems;
    std::set<std::string> taken;
};

Result<> TomlReader::read(std::string_view text, const QString& fileName, const Inner& fields)
{
    FileProblems problems;
    try {
        const toml::table root = toml::parse(text);
        TomlTable{root, "", problems, {}}.read(fields);
    } catch (const toml::parse_error& error) {
        problems.add(error.source().begin.line, toQString(error.description()));
    }
    if (problems.count() > 0) {
        return failure(ErrorCode::InvalidInput, problems.text(fileName));
    }
    return {};
}

bool TomlReader::has(std::string_view key, bool) const
{
    return m_table.toml.contains(key);
}

void TomlReader::number(std::string_view key, double& value, Range range)
{
    const toml::node* node = m_table.take(key);
    if (node == nullptr) {
        return;
    }
    const auto found = node->is_number() ? node->value<double>() : std::nullopt;
    if (!found || !std::isfinite(*found)) {
        m_table.complain(key, *node, Text::tr("a number is expected"));
    } else if (*found < range.min || *found > range.max) {
        m_table.complain(key, *node, Text::tr("%1 is not within %2…%3").arg(*found).arg(range.min).arg(range.max));
    } else {
        value = *found;
    }
}

void TomlReader::whole(std::string_view key, std::int64_t& value, Range range)
{
    auto found = static_cast<double>(value);
    number(key, found, range);
    if (found != std::floor(found)) {
        m_table.complain(key, *m_table.toml.get(key), Text::tr("a whole number is expected"));
    } else {
        value = static_cast<std::int64_t>(found);
    }
}

void TomlReader::countOf(std::string_view key, std::int64_t& value, std::string_view listKey)
{
    const toml::array* array = m_table.toml[listKey].as_array();
    whole(key, value, {0.0, array != nullptr ? static_cast<double>(array->size()) : 0.0});
}

void TomlReader::text(std::string_view key, std::string& value)
{
    const toml::node* node = m_table.take(key);
    if (node == nullptr) {
        return;
    }
    const auto* found = node->as_string();
    if (found == nullptr || hasControlCharacters(found->get())) {
        m_table.complain(key, *node, Text::tr("a text in quotes is expected, without control characters"));
    } else {
        value = found->get();
    }
}

void TomlReader::text(std::string_view key, QString& value)
{
    std::string bytes = value.toStdString();
    text(key, bytes);
    value = toQString(bytes);
}

void TomlReader::flag(std::string_view key, bool& value)
{
    const toml::node* node = m_table.take(key);
    if (node == nullptr) {
        return;
    }
    if (const auto* found = node->as_boolean()) {
        value = found->get();
    } else {
        m_table.complain(key, *node, Text::tr("true or false is expected"));
    }
}

void TomlReader::time(std::string_view key, UtcTime& value)
{
    const toml::node* node = m_table.take(key);
    if (node == nullptr) {
        return;
    }
    const auto* found = node->as_date_time();
    const bool isUtc = found != nullptr && found->get().offset && found->get().offset->minutes == 0;
    if (!isUtc || found->get().date.year < kEarliest || found->get().date.year > kLatest) {
        m_table.complain(key, *node, Text::tr("a UTC time is expected, like 2026-11-21T21:34:00.000Z"));
    } else {
        value = utcOf(found->get());
    }
}

void TomlReader::choiceIndex(std::string_view key, std::size_t& index, std::span<const std::string_view, 2> names)
{
    const toml::node* node = m_table.take(key);
    if (node == nullptr) {
        return;
    }
    const std::string name = node->value_exact<std::string>().value_or(std::string());
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
        m_table.complain(key, *node,
                         Text::tr("\"%1\" or \"%2\" is expected").arg(toQString(names[0]), toQString(names[1])));
    } else {
        index = static_cast<std::size_t>(found - names.begin());
    }
}

void TomlReader::inside(std::string_view key, const Inner& fields)
{
    if (const toml::node* node = m_table.take(key)) {
        m_table.readInner(*node, m_table.pathOf(key), fields);
    }
}

void TomlReader::each(std::string_view key, const Inner& fields)
{
    if (!m_table.toml.contains(key)) {
        return;
    }
    const toml::node* node = m_table.take(key);
    const toml::array* array = node->as_array();
    if (array == nullptr) {
        m_table.complain(key, *node, Text::tr("\"[[%1]]\" is expected").arg(toQString(m_table.pathOf(key))));
        return;
    }
    std::size_t row = 0;
    for (const toml::node& one : *array) {
        m_table.readInner(one, m_table.pathOf(key) + "[" + std::to_string(++row) + "]", fields);
    }
}

}  // namespace boresight::records

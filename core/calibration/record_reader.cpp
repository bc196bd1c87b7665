// SPDX-License-Identifier: GPL-3.0-or-later
// Includes toml++, which is large and slow to compile.
#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/calibration/record_fields.h"
#include "core/calibration/record_text.h"

#include <toml++/toml.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace boresight::calibration {
namespace {

using namespace boresight::calibration::record;

constexpr int kEarliest = 1970;
constexpr int kLatest = 2200;

struct Problem
{
    std::size_t line = 0;
    std::string text;
};

// Reads one table by the fields of what it describes, and complains of what is left over.
class TableReader
{
public:
    TableReader(const toml::table& table, std::string path, std::vector<Problem>& problems)
        : m_table(table), m_path(std::move(path)), m_problems(problems)
    {}

    void angle(std::string_view key, Angle& value, Range range)
    {
        double degrees = value.degrees();
        number(key, degrees, range);
        value = Angle::fromDegrees(degrees);
    }

    void optionalAngle(std::string_view key, std::optional<Angle>& value, Range range)
    {
        if (m_table.contains(key)) {
            angle(key, value.emplace(), range);
        }
    }

    void number(std::string_view key, double& value, Range range)
    {
        const toml::node* node = take(key);
        const auto found = node != nullptr && node->is_number() ? node->value<double>() : std::nullopt;
        if (node == nullptr) {
            return;
        }
        if (!found || !std::isfinite(*found)) {
            complain(key, *node, Text::tr("a number is expected"));
        } else if (*found < range.min || *found > range.max) {
            complain(key, *node, Text::tr("%1 is not within %2…%3").arg(*found).arg(range.min).arg(range.max));
        } else {
            value = *found;
        }
    }

    void text(std::string_view key, std::string& value)
    {
        const toml::node* node = take(key);
        if (node == nullptr) {
            return;
        }
        const auto* found = node->as_string();
        if (found == nullptr || hasControlCharacters(found->get())) {
            complain(key, *node, Text::tr("a text in quotes is expected, without control characters"));
        } else {
            value = found->get();
        }
    }

    void flag(std::string_view key, bool& value)
    {
        if (const toml::node* node = take(key)) {
            const auto* found = node->as_boolean();
            found != nullptr ? void(value = found->get()) : complain(key, *node, Text::tr("true or false is expected"));
        }
    }

    void time(std::string_view key, UtcTime& value)
    {
        const toml::node* node = take(key);
        if (node == nullptr) {
            return;
        }
        const auto* found = node->as_date_time();
        const bool isUtc = found != nullptr && found->get().offset && found->get().offset->minutes == 0;
        if (!isUtc || found->get().date.year < kEarliest || found->get().date.year > kLatest) {
            complain(key, *node, Text::tr("a UTC time is expected, like 2026-11-21T21:34:00.000Z"));
        } else {
            value = utcOf(found->get());
        }
    }

    template <class Choice>
    void choice(std::string_view key, Choice& value, std::span<const std::string_view> names)
    {
        const toml::node* node = take(key);
        if (node == nullptr) {
            return;
        }
        const std::string name = node->value_exact<std::string>().value_or(std::string());
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            complain(key, *node,
                     Text::tr("\"%1\" or \"%2\" is expected").arg(toQString(names[0]), toQString(names[1])));
        } else {
            value = static_cast<Choice>(found - names.begin());
        }
    }

    template <class Value>
    void table(std::string_view key, Value& value)
    {
        if (const toml::node* node = take(key)) {
            readTable(*node, pathOf(key), value);
        }
    }

    template <class Value>
    void optionalTable(std::string_view key, std::optional<Value>& value)
    {
        if (m_table.contains(key)) {
            table(key, value.emplace());
        }
    }

    template <class Value>
    void list(std::string_view key, std::vector<Value>& values)
    {
        if (!m_table.contains(key)) {
            return;  // there is none
        }
        const toml::node* node = take(key);
        const toml::array* array = node->as_array();
        if (array == nullptr) {
            return complain(key, *node, Text::tr("\"[[%1]]\" is expected").arg(toQString(pathOf(key))));
        }
        for (const toml::node& one : *array) {
            values.emplace_back();
            readTable(one, pathOf(key) + "[" + std::to_string(values.size()) + "]", values.back());
        }
    }

    void complainOfTheRest()
    {
        for (const auto& [key, node] : m_table) {
            if (!m_taken.contains(std::string(key.str()))) {
                m_problems.push_back(
                    {key.source().begin.line, pathOf(key.str()) + ": " + Text::tr("unknown key").toStdString()});
            }
        }
    }

    void complain(std::string_view key, const toml::node& node, const QString& reason)
    {
        m_problems.push_back({node.source().begin.line, pathOf(key) + ": " + reason.toStdString()});
    }

private:
    template <class Value>
    void readTable(const toml::node& node, const std::string& path, Value& value)
    {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            m_problems.push_back(
                {node.source().begin.line, path + ": " + Text::tr("a table is expected").toStdString()});
            return;
        }
        TableReader reader(*table, path, m_problems);
        fields(reader, value);
        reader.complainOfTheRest();
    }

    // Null if it is missing, which is complained of.
    const toml::node* take(std::string_view key)
    {
        m_taken.emplace(key);
        const toml::node* node = m_table.get(key);
        if (node == nullptr) {
            complainOfMissing(key);
        }
        return node;
    }

    void complainOfMissing(std::string_view key)
    {
        m_problems.push_back({m_table.source().begin.line, pathOf(key) + ": " + Text::tr("is missing").toStdString()});
    }

    [[nodiscard]] std::string pathOf(std::string_view key) const
    {
        return (m_path.empty() ? "" : m_path + ".") + std::string(key);
    }

    static UtcTime utcOf(const toml::date_time& time)
    {
        const std::chrono::sys_days day{std::chrono::year(time.date.year) / time.date.month / time.date.day};
        return std::chrono::time_point_cast<UtcTime::duration>(
            day + std::chrono::hours(time.time.hour) + std::chrono::minutes(time.time.minute) +
            std::chrono::seconds(time.time.second) + std::chrono::nanoseconds(time.time.nanosecond));
    }

    const toml::table& m_table;
    std::string m_path;
    std::vector<Problem>& m_problems;
    std::set<std::string> m_taken;
};

struct WholeFile
{
    double version = 0.0;
    double inForce = 0.0;
    std::vector<CalibrationRecord> entries;
    std::vector<CalibrationRecord> superseded;
};

void readVersionAndPlace(TableReader& reader, const toml::table& root, WholeFile& file)
{
    reader.number("version", file.version, {kVersion, kVersion});
    reader.list("calibration", file.entries);
    reader.list("superseded", file.superseded);
    reader.number("in_force", file.inForce, {0.0, static_cast<double>(file.entries.size())});
    if (file.inForce != std::floor(file.inForce)) {
        reader.complain("in_force", *root.get("in_force"), Text::tr("a whole number is expected"));
    }
    reader.complainOfTheRest();
}

std::string inOrder(std::vector<Problem> problems, const std::string& fileName)
{
    std::stable_sort(problems.begin(), problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    std::string all;
    for (const Problem& problem : problems) {
        all +=
            (all.empty() ? "" : "\n") + fileName + ":" + std::to_string(problem.line) + ": " + printable(problem.text);
    }
    return all;
}

}  // namespace

Result<CalibrationHistory> parseHistory(std::string_view text, const std::string& fileName)
{
    WholeFile file;
    std::vector<Problem> problems;
    try {
        const toml::table root = toml::parse(text, fileName);
        TableReader reader(root, "", problems);
        readVersionAndPlace(reader, root, file);
    } catch (const toml::parse_error& error) {
        problems = {{error.source().begin.line, std::string(error.description())}};
    }
    if (!problems.empty()) {
        return failure(ErrorCode::InvalidInput, inOrder(std::move(problems), fileName));
    }
    return CalibrationHistory(std::move(file.entries), static_cast<std::size_t>(file.inForce),
                              std::move(file.superseded));
}

}  // namespace boresight::calibration

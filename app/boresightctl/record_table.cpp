// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/record_table.h"

#include <QString>

#include <algorithm>
#include <array>
#include <cstdio>

namespace boresight::ctl {
namespace {

using Cells = std::vector<std::string>;

std::string csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

std::string jsonText(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
            quoted += code;
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

Cells namesOf(const std::vector<TableColumn>& columns)
{
    Cells names;
    for (const TableColumn& column : columns) {
        names.emplace_back(column.name);
    }
    return names;
}

std::string csvLine(const Cells& cells)
{
    std::string line;
    for (const std::string& cell : cells) {
        line += (&cell == cells.data() ? "" : ",") + csvCell(cell);
    }
    return line + '\n';
}

std::string jsonObject(const std::vector<TableColumn>& columns, const Cells& cells)
{
    std::string object = "{";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string number = cells[i].empty() ? "null" : cells[i];
        object += (i == 0 ? "" : ", ") + jsonText(std::string(columns[i].name)) + ": " +
                  (columns[i].isNumber ? number : jsonText(cells[i]));
    }
    return object + '}';
}

// Width on a terminal. A name of a satellite is hardly wider than its number of letters.
std::size_t widthOf(const std::string& text)
{
    return static_cast<std::size_t>(QString::fromStdString(text).size());
}

std::string tableLine(const RecordTable& table, const Cells& cells, const std::vector<std::size_t>& widths)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string blanks(widths[i] - widthOf(cells[i]), ' ');
        line += (i == 0 ? "" : "  ") + (table.columns[i].isNumber ? blanks + cells[i] : cells[i] + blanks);
    }
    return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

std::string inColumns(const RecordTable& table)
{
    const Cells names = namesOf(table.columns);
    std::vector<std::size_t> widths(names.size());
    const auto widen = [&](const Cells& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            widths[i] = std::max(widths[i], widthOf(cells[i]));
        }
    };
    widen(names);
    std::ranges::for_each(table.rows, widen);
    std::string text = tableLine(table, names, widths);
    for (const Cells& row : table.rows) {
        text += tableLine(table, row, widths);
    }
    return text;
}

}  // namespace

std::optional<TableFormat> parseTableFormat(std::string_view name)
{
    constexpr std::array<std::string_view, 3> kNames{"csv", "table", "json"};  // in the order of TableFormat
    const auto* const found = std::ranges::find(kNames, name);
    if (found == kNames.end()) {
        return std::nullopt;
    }
    return static_cast<TableFormat>(found - kNames.begin());
}

std::string RecordTable::text(TableFormat format) const
{
    if (format == TableFormat::Table) {
        return inColumns(*this);
    }
    const bool isJson = format == TableFormat::Json;
    std::string text = isJson ? "[" : csvLine(namesOf(columns));
    for (const Cells& row : rows) {
        text += isJson ? (&row == rows.data() ? "\n" : ",\n") + jsonObject(columns, row) : csvLine(row);
    }
    return isJson ? text + "\n]\n" : text;
}

}  // namespace boresight::ctl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Rows that another program reads, or a person: as CSV with a line of names, as a JSON array of objects with these
// names, or as columns of one width. Pure.
namespace boresight::ctl {

enum class TableFormat
{
    Csv,
    Table,
    Json
};

// "csv", "table" or "json". Empty for all else.
[[nodiscard]] std::optional<TableFormat> parseTableFormat(std::string_view name);

struct TableColumn
{
    std::string_view name;
    bool isNumber = false;
};

struct RecordTable
{
    std::vector<TableColumn> columns;
    std::vector<std::vector<std::string>> rows;  // UTF-8. An empty number is one that there is not: null

    [[nodiscard]] std::string text(TableFormat format) const;
};

}  // namespace boresight::ctl

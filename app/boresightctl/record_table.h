// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Rows for another program or for a person: as CSV with a header line, as a JSON array of objects, or as columns of
// equal width. Pure.
namespace boresight::ctl {

enum class TableFormat
{
    Csv,
    Table,
    Json
};

// "csv", "table" or "json". Empty for any other text.
[[nodiscard]] std::optional<TableFormat> parseTableFormat(std::string_view name);

struct TableColumn
{
    std::string_view name;
    bool isNumber = false;
};

struct RecordTable
{
    std::vector<TableColumn> columns;
    std::vector<std::vector<std::string>> rows;  // UTF-8. An empty number is unknown; JSON has null for it

    [[nodiscard]] std::string text(TableFormat format) const;
};

}  // namespace boresight::ctl

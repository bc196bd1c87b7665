// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_reader.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/text_lines.h"
#include "core/tables/direction_reader.h"
#include "core/tables/oem_reader.h"
#include "core/tables/oem_xml.h"

#include <algorithm>
#include <utility>

namespace boresight::tables {
namespace {

// The first line that is not empty.
struct Beginning
{
    std::string_view text;
    int line = 1;
};

Beginning beginningOf(std::string_view text)
{
    orbit::TextLines lines(text);
    while (lines.next()) {
        if (const std::string_view line = trimmed(lines.line()); !line.empty()) {
            return {.text = line, .line = lines.number()};
        }
    }
    return {};
}

Table tableOf(Oem oem)
{
    std::vector<TableSpan> spans = spansOf(oem.segments);
    return {.name = toQString(oem.name), .rows = std::move(oem.segments), .spans = std::move(spans)};
}

TableReading<Table> read(std::string_view text, const QString& name)
{
    const Beginning beginning = beginningOf(text);
    const auto refused = [&](const QString& reason) {
        return tl::unexpected(TableProblem{.line = beginning.line, .reason = reason});
    };
    if (beginning.text.starts_with('<')) {
        return readOemXml(text).map(tableOf);
    }
    if (beginning.text.starts_with(kOemStart)) {
        return readOem(text).map(tableOf);
    }
    if (beginning.text.starts_with("CCSDS_")) {
        return refused(Text::tr("The file is a CCSDS message, but not an OEM. Boresight tracks tables and OEM."));
    }
    return readDirections(text).map([&](DirectionRows rows) {
        std::vector<TableSpan> spans = spansOf(rows);
        return Table{.name = name, .rows = std::move(rows), .spans = std::move(spans)};
    });
}

}  // namespace

Result<SharedTable> readTable(std::string_view text, const QString& file)
{
    TableReading<Table> table = read(text, file.section(u'/', -1));
    if (!table) {
        return failure(
            ErrorCode::InvalidInput,
            QStringLiteral("%1:%2: %3").arg(file, QString::number(table.error().line), table.error().reason));
    }
    return std::make_shared<const Table>(*std::move(table));
}

}  // namespace boresight::tables

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/direction_reader.h"

#include "core/base/numbers.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/text_lines.h"
#include "core/elements/written_time.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace boresight::tables {
namespace {

constexpr std::string_view kSeparators = ",; \t";
constexpr Angle kFarthest = 90_deg;  // between two rows

// The first columns of a line.
struct Columns
{
    std::array<std::string_view, 4> texts{};
    std::size_t count = 0;
};

// Blanks around a comma are part of the separator. Two commas enclose an empty column.
Columns columnsOf(std::string_view line)
{
    Columns columns;
    for (line = trimmed(line); columns.count < columns.texts.size();) {
        const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
        columns.texts[columns.count++] = line.substr(0, end);
        if (end == line.size()) {
            break;
        }
        line.remove_prefix(std::min(line.find_first_not_of(" \t", end), line.size()));
        if (!line.empty() && (line.front() == ',' || line.front() == ';')) {
            line = trimmed(line.substr(1));
        }
    }
    return columns;
}

bool isClock(std::string_view text)
{
    return text.find(':') != std::string_view::npos;
}

// A header line has no digit in the column of the time.
bool isHeader(const Columns& columns)
{
    return columns.texts[0].find_first_of("0123456789") == std::string_view::npos;
}

Result<double> degreesOf(std::string_view text, double most, const QString& what)
{
    const auto degrees = parseFinite(text);
    if (!degrees) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("The %1 \"%2\" is not a number of degrees.").arg(what, orbit::quoted(text)));
    }
    if (*degrees < -most || *degrees > most) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("The %1 is %2°. It must be from -%3° to %3°.").arg(what, orbit::quoted(text)).arg(most));
    }
    return *degrees;
}

Result<DirectionRow> rowOf(Columns columns)
{
    std::string time(columns.texts[0]);
    if (columns.count > 1 && isClock(columns.texts[1]) && !isClock(columns.texts[0])) {  // "2024-05-10 04:50:02"
        time += 'T' + std::string(columns.texts[1]);
        std::ranges::rotate(columns.texts, columns.texts.begin() + 1);
        --columns.count;
    }
    const auto date = orbit::parseWrittenTime(time);
    if (!date) {
        return failure(ErrorCode::InvalidInput, Text::tr("\"%1\" is not a time. A row is a time in UTC like "
                                                         "2024-05-10T04:50:02Z or in Unix seconds, an azimuth and an "
                                                         "elevation.")
                                                    .arg(orbit::quoted(time)));
    }
    if (columns.count < 3) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("The row has no elevation. A row is a time, an azimuth and an elevation."));
    }
    return degreesOf(columns.texts[1], 360.0, Text::tr("azimuth")).and_then([&](double azimuth) {
        return degreesOf(columns.texts[2], 90.0, Text::tr("elevation")).map([&](double elevation) {
            return DirectionRow{.time = atomicTime(*date, TimeSystem::Utc),
                                .direction = {.azimuth = Angle::fromDegrees(azimuth).wrapped360(),
                                              .elevation = Angle::fromDegrees(elevation)}};
        });
    });
}

Result<> follows(const DirectionRow& row, const DirectionRows& rows)
{
    if (rows.empty()) {
        return {};
    }
    const DirectionRow& last = rows.back();
    if (row.time <= last.time) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("The time is not later than the time in the row above. Sort the rows by time."));
    }
    const Angle apart = angleBetween(last.direction, row.direction);
    if (row.time - last.time <= kLongestStep && apart >= kFarthest) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("The direction is %1 from the direction in the row above. It must "
                                "be below 90°. Add rows between them.")
                           .arg(degreesText(apart, 1)));
    }
    if (rows.size() >= kMostRows) {
        return failure(ErrorCode::InvalidInput, Text::tr("The table has more than %1 rows. Split it.").arg(kMostRows));
    }
    return {};
}

// True for a row without a neighbour within kLongestStep on either side. Such a row is an error, because nothing can be
// interpolated there.
bool isAlone(const DirectionRows& rows, std::size_t at)
{
    const bool hasBefore = at > 0 && rows[at].time - rows[at - 1].time <= kLongestStep;
    const bool hasAfter = at + 1 < rows.size() && rows[at + 1].time - rows[at].time <= kLongestStep;
    return !hasBefore && !hasAfter;
}

tl::unexpected<TableProblem> alone(int line)
{
    static_assert(kLongestStep == std::chrono::hours(1));
    return tl::unexpected(
        TableProblem{.line = line, .reason = Text::tr("The row has no other row within an hour. Add rows.")});
}

}  // namespace

TableReading<DirectionRows> readDirections(std::string_view text)
{
    DirectionRows rows;
    orbit::TextLines lines(text);
    bool mayBeHeader = true;
    int lastLine = 1;  // line number of the last row
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty() || line.front() == '#') {
            continue;
        }
        const Columns columns = columnsOf(line);
        if (std::exchange(mayBeHeader, false) && isHeader(columns)) {
            continue;
        }
        const Result<DirectionRow> row = rowOf(columns);
        const Result<> fits = row.and_then([&](const DirectionRow& one) { return follows(one, rows); });
        if (!fits) {
            return tl::unexpected(TableProblem{.line = lines.number(), .reason = fits.error().text});
        }
        rows.push_back(*row);
        if (rows.size() > 1 && isAlone(rows, rows.size() - 2)) {
            return alone(lastLine);
        }
        lastLine = lines.number();
    }
    if (rows.empty()) {
        return tl::unexpected(
            TableProblem{.reason = Text::tr("There is no row. A row is a time, an azimuth and an elevation.")});
    }
    if (isAlone(rows, rows.size() - 1)) {
        return alone(lastLine);
    }
    return rows;
}

std::vector<TableSpan> spansOf(const DirectionRows& rows)
{
    std::vector<TableSpan> spans;
    for (const DirectionRow& row : rows) {
        if (!spans.empty() && row.time - spans.back().to <= kLongestStep) {
            spans.back().to = row.time;
        } else {
            spans.push_back({.from = row.time, .to = row.time});
        }
    }
    return spans;
}

}  // namespace boresight::tables

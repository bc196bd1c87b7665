// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/table_promises.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/tables/table_path.h"
#include "core/tables/table_reader.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::tables;

const orbit::Observer kSite({.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0});
constexpr std::size_t kMostSpans = 20;  // number of time spans that are checked

void checkReason(const std::string& reason)
{
    require(!reason.empty() && reason.size() < 400, "a refusal has a short reason");
    require(!hasControlCharacters(reason), "a reason is one printable line");
}

void checkRefusal(const std::string& reason, std::string_view text)
{
    checkReason(reason);
    require(reason.starts_with("a.txt:"), "a refusal names the file");
    const std::string rest = reason.substr(6);
    const auto line = parseInteger(rest.substr(0, rest.find(':')));
    const auto lines = std::ranges::count(text, '\n') + 1;
    require(line && *line >= 1 && *line <= lines, "a refusal names a line of the text");
}

void checkPlace(const Result<TablePlace>& place)
{
    if (!place) {
        require(place.error().code == ErrorCode::NotAvailable, "where there is no way it is not available");
        checkReason(place.error().text.toStdString());
        return;
    }
    const double azimuth = place->direction.azimuth.degrees();
    const double elevation = place->direction.elevation.degrees();
    require(azimuth >= 0.0 && azimuth < 360.0 && std::abs(elevation) <= 90.0 + 1e-9, "a place is a direction");
    require(!place->kilometres || std::isfinite(*place->kilometres), "a range is finite");
}

void checkSpan(TablePath& path, const TableSpan& span)
{
    constexpr std::chrono::minutes kSearched{10};
    for (int part = 0; part <= 5; ++part) {
        checkPlace(path.at(utcTime(span.from + (span.to - span.from) / 5 * part)));
    }
    const UtcTime from = utcTime(span.from);
    const auto stay = path.nextStay(from, from + kSearched);
    if (!stay) {
        checkReason(stay.error().text.toStdString());
        return;
    }
    require(stay->from >= from && stay->from <= from + kSearched, "a stay begins where it is searched");
    require(!stay->to || (*stay->to >= stay->from && *stay->to <= from + kSearched), "a stay ends after it began");
}

void checkTable(const SharedTable& table)
{
    require(!table->spans.empty(), "a table has a time");
    require(!hasControlCharacters(table->name.toStdString()), "a name is printable");
    TablePath path(table, kSite);
    AtomicTime last = AtomicTime::min();
    for (const TableSpan& span : table->spans) {
        require(span.from <= span.to && span.from > last, "the spans of a table are in the order of time");
        last = span.to;
    }
    for (std::size_t i = 0; i < std::min(table->spans.size(), kMostSpans); ++i) {
        checkSpan(path, table->spans[i]);
    }
    require(!path.at(utcTime(table->spans.front().from - std::chrono::seconds(5))), "nothing is before the table");
    require(!path.at(utcTime(table->spans.back().to + std::chrono::seconds(5))), "nothing is behind the table");
}

std::string withLongEnds(std::string_view text)
{
    std::string changed;
    for (const char character : text) {
        changed += character == '\n' ? "\r\n" : std::string(1, character);
    }
    return changed;
}

}  // namespace

void feedTable(std::string_view text)
{
    const Result<SharedTable> table = readTable(text, QStringLiteral("a.txt"));
    if (!table) {
        checkRefusal(table.error().text.toStdString(), text);
        return;
    }
    checkTable(*table);
    const auto again = readTable(withLongEnds(text), QStringLiteral("a.txt"));
    require(again && **again == **table, "line ends of both kinds mean the same");
    accept();
}

}  // namespace boresight::fuzz

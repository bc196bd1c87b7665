// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_reader.h"

#include "core/base/trimmed.h"
#include "core/elements/text_lines.h"
#include "core/tables/oem_parts.h"

#include <utility>

namespace boresight::tables {

TableReading<Oem> readOem(std::string_view text)
{
    OemParts parts;
    orbit::TextLines lines(text);
    int last = 1;
    const auto problem = [&last](const Result<>& taken) {
        return tl::unexpected(TableProblem{.line = last, .reason = taken.error().text});
    };
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        last = lines.number();
        if (line.empty() || line == "COMMENT" || line.starts_with("COMMENT ")) {
            continue;
        }
        if (const Result<> taken = parts.take(line); !taken) {
            return problem(taken);
        }
    }
    if (const Result<> ended = parts.end(); !ended) {
        return problem(ended);
    }
    return std::move(parts.oem());
}

std::vector<TableSpan> spansOf(const OrbitSegments& segments)
{
    std::vector<TableSpan> spans;
    for (const OrbitSegment& segment : segments) {
        if (!spans.empty() && spans.back().to == segment.from) {
            spans.back().to = segment.to;
        } else {
            spans.push_back({.from = segment.from, .to = segment.to});
        }
    }
    return spans;
}

}  // namespace boresight::tables

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/omm_csv.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/omm_record.h"
#include "core/elements/text_lines.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace boresight::orbit {

namespace {

using CsvFields = std::vector<std::string>;

// Reads one value in quotes, from its first quote on. A doubled quote stands for one quote. False: the quotes do not
// end.
bool takeQuoted(std::string_view& rest, std::string& value)
{
    rest.remove_prefix(1);
    while (!rest.empty()) {
        const char character = rest.front();
        rest.remove_prefix(1);
        if (character == '"' && !rest.starts_with('"')) {
            return true;
        }
        if (character == '"') {
            rest.remove_prefix(1);
        }
        value += character;
    }
    return false;
}

// Empty if quotes do not end. Fields after the first thousand are ignored, so that a line of commas cannot fill the
// memory.
std::optional<CsvFields> csvFields(std::string_view line)
{
    constexpr std::size_t kMostFields = 1000;
    CsvFields fields;
    for (bool more = true; more && fields.size() < kMostFields;) {
        std::string value;
        if (line.starts_with('"') && !takeQuoted(line, value)) {
            return std::nullopt;
        }
        const std::size_t end = std::min(line.find(','), line.size());
        value += line.substr(0, end);
        fields.push_back(std::move(value));
        more = end < line.size();
        line.remove_prefix(more ? end + 1 : end);
    }
    return fields;
}

}  // namespace

ElementList readOmmCsv(std::string_view text)
{
    ElementList list;
    std::optional<CsvFields> keys;
    TextLines lines(text);
    while (!list.isHopeless() && lines.next()) {
        const auto values = lines.line().empty() ? CsvFields{} : csvFields(lines.line());
        if (!values) {
            list.addProblem(lines.number(), Text::tr("A text in double quotes does not end in its line."));
        } else if (values->empty()) {
            continue;
        } else if (!keys) {
            keys = values;
        } else if (values->size() != keys->size()) {
            list.addProblem(
                lines.number(),
                Text::tr("The line has %1 values. The header has %2.").arg(values->size()).arg(keys->size()));
        } else {
            OmmRecord record;
            for (std::size_t i = 0; i < keys->size(); ++i) {
                record.set(trimmed((*keys)[i]), (*values)[i], lines.number());
            }
            record.addTo(list);
        }
    }
    return list;
}

}  // namespace boresight::orbit

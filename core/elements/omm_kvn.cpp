// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/omm_kvn.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/omm_record.h"
#include "core/elements/text_lines.h"

#include <algorithm>

namespace boresight::orbit {

namespace {

std::string_view withoutUnit(std::string_view value)
{
    const std::size_t bracket = value.ends_with(']') ? value.rfind('[') : std::string_view::npos;
    return bracket == std::string_view::npos ? value : trimmed(value.substr(0, bracket));
}

}  // namespace

ElementList readOmmKvn(std::string_view text)
{
    ElementList list;
    OmmRecord record;
    const auto end = [&] {
        if (!record.isEmpty()) {
            record.addTo(list);
            record = {};
        }
    };
    TextLines lines(text);
    while (!list.isHopeless() && lines.next()) {
        const std::string_view line = trimmed(lines.line());
        const std::size_t equals = line.find('=');
        if (line.empty() || line.starts_with("COMMENT")) {
            continue;
        }
        if (equals == std::string_view::npos) {
            list.addProblem(lines.number(),
                            Text::tr("\"%1\" is not a line of the form KEY = value.").arg(quoted(line)));
            continue;
        }
        const std::string_view key = trimmed(line.substr(0, equals));
        if (key == "CCSDS_OMM_VERS" || record.has(key)) {
            end();
        }
        const std::string_view value = trimmed(line.substr(equals + 1));
        record.set(key, key == "OBJECT_NAME" ? value : withoutUnit(value), lines.number());
    }
    end();
    return list;
}

}  // namespace boresight::orbit

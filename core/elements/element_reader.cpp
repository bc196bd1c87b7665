// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_reader.h"

#include "core/base/trimmed.h"
#include "core/elements/omm_csv.h"
#include "core/elements/omm_json.h"
#include "core/elements/omm_kvn.h"
#include "core/elements/omm_xml.h"
#include "core/elements/satdata_reader.h"
#include "core/elements/text_lines.h"
#include "core/elements/tle_reader.h"

namespace boresight::orbit {

namespace {

// The first line that is neither empty nor a comment of KVN.
std::string_view firstLine(std::string_view text)
{
    TextLines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (!line.empty() && !line.starts_with("COMMENT")) {
            return line;
        }
    }
    return {};
}

// For example "[Satellite]" or "[25544]". JSON would have values in its brackets.
bool isGroup(std::string_view line)
{
    return line.size() > 2 && line.front() == '[' && line.back() == ']' &&
           line.find_first_of("{}\",") == std::string_view::npos;
}

}  // namespace

ElementForm elementForm(std::string_view text)
{
    const std::string_view line = firstLine(text);
    if (isGroup(line)) {
        return ElementForm::Satdata;
    }
    if (line.starts_with('[') || line.starts_with('{')) {
        return ElementForm::Json;
    }
    if (line.starts_with('<')) {
        return ElementForm::Xml;
    }
    if (line.find("MEAN_MOTION") != std::string_view::npos && line.find(',') != std::string_view::npos) {
        return ElementForm::Csv;
    }
    const bool isKvn = line.starts_with("CCSDS_OMM_VERS") || line.starts_with("OBJECT_NAME");
    return isKvn && line.find('=') != std::string_view::npos ? ElementForm::Kvn : ElementForm::Tle;
}

ElementList readElements(std::string_view text)
{
    switch (elementForm(text)) {
        case ElementForm::Json:
            return readOmmJson(text);
        case ElementForm::Csv:
            return readOmmCsv(text);
        case ElementForm::Xml:
            return readOmmXml(text);
        case ElementForm::Kvn:
            return readOmmKvn(text);
        case ElementForm::Satdata:
            return readSatdata(text);
        case ElementForm::Tle:
            break;
    }
    return readTle(text);
}

}  // namespace boresight::orbit

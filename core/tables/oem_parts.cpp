// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_parts.h"

#include "core/base/text.h"
#include "core/elements/element_check.h"
#include "core/tables/oem_row.h"

#include <algorithm>
#include <utility>

namespace boresight::tables {
namespace {

tl::unexpected<Error> wrong(const QString& reason)
{
    return failure(ErrorCode::InvalidInput, reason);
}

}  // namespace

Result<> OemParts::take(std::string_view line)
{
    switch (m_part) {
        case Part::Start:
            return takeStart(line);
        case Part::Header:
            return takeHeader(line);
        case Part::Meta:
            return takeMeta(line);
        case Part::Rows:
            return takeRow(line);
        case Part::Covariance:
            m_part = line == "COVARIANCE_STOP" ? Part::AfterCovariance : m_part;
            return {};
        case Part::AfterCovariance:
            break;
    }
    return line == "META_START" ? endRows().and_then([this] { return begin(); })
                                : wrong(Text::tr("After COVARIANCE_STOP only META_START may follow."));
}

Result<> OemParts::takeStart(std::string_view line)
{
    const auto entry = oemEntry(line);
    if (!entry || entry->key != kOemStart) {
        return wrong(Text::tr("An OEM begins with CCSDS_OEM_VERS."));
    }
    if (!entry->value.starts_with("1.") && !entry->value.starts_with("2.") && !entry->value.starts_with("3.")) {
        return wrong(Text::tr("The version \"%1\" of OEM is not known. Boresight reads the versions 1 to 3.")
                         .arg(orbit::quoted(entry->value)));
    }
    m_part = Part::Header;
    return {};
}

Result<> OemParts::takeHeader(std::string_view line)
{
    if (line == "META_START") {
        return begin();
    }
    return oemEntry(line) ? Result<>()
                          : wrong(Text::tr("\"%1\" is not a line of the form KEY = value.").arg(orbit::quoted(line)));
}

Result<> OemParts::begin()
{
    m_meta = {};
    m_part = Part::Meta;
    return {};
}

Result<> OemParts::takeMeta(std::string_view line)
{
    if (line != "META_STOP") {
        return m_meta.take(line);
    }
    return isSameObject().and_then([this] { return m_meta.segment(); }).map([this](OrbitSegment segment) {
        m_segment = std::move(segment);
        m_part = Part::Rows;
    });
}

Result<> OemParts::isSameObject() const
{
    const std::string name = orbit::nameOf(m_meta.value("OBJECT_NAME"));
    return m_oem.segments.empty() || name == m_oem.name
               ? Result<>()
               : wrong(Text::tr("The object is \"%1\", but the object above is \"%2\". Write a file for each object.")
                           .arg(toQString(name), toQString(m_oem.name)));
}

Result<> OemParts::takeRow(std::string_view line)
{
    if (line == "META_START") {
        return endRows().and_then([this] { return begin(); });
    }
    if (line == "COVARIANCE_START") {
        m_part = Part::Covariance;
        return {};
    }
    return oemRow(line, m_meta.timeSystem())
        .and_then([this](const OrbitRow& row) {
            return (m_segment.rows.empty() ? Result<>() : follows(m_segment.rows.back(), row)).map([&] { return row; });
        })
        .and_then([this](const OrbitRow& row) -> Result<> {
            if (++m_rows > kMostRows) {
                return wrong(Text::tr("The file has more than %1 rows. Split it.").arg(kMostRows));
            }
            m_segment.rows.push_back(row);
            return {};
        });
}

Result<> OemParts::endRows()
{
    if (m_segment.rows.size() < 2) {
        return wrong(Text::tr("The segment that ends here has fewer than two rows."));
    }
    m_segment.nodes = std::min(m_segment.nodes, m_segment.rows.size());
    m_segment.from = std::max(m_segment.from, m_segment.rows.front().time);
    m_segment.to = std::min(m_segment.to, m_segment.rows.back().time);
    if (m_segment.from >= m_segment.to) {
        return wrong(
            Text::tr("The segment that ends here has no rows in its usable time. Correct "
                     "USEABLE_START_TIME and USEABLE_STOP_TIME."));
    }
    if (!m_oem.segments.empty() && m_segment.from < m_oem.segments.back().to) {
        return wrong(
            Text::tr("This segment begins before the end of the segment above it. Sort the segments, or set "
                     "USEABLE_START_TIME."));
    }
    if (m_oem.segments.empty()) {
        m_oem.name = orbit::nameOf(m_meta.value("OBJECT_NAME"));
    }
    m_oem.segments.push_back(std::exchange(m_segment, {}));
    return {};
}

Result<> OemParts::end()
{
    switch (m_part) {
        case Part::Rows:
        case Part::AfterCovariance:
            return endRows();
        case Part::Covariance:
            return wrong(Text::tr("The file is cut: COVARIANCE_STOP is missing."));
        case Part::Meta:
            return wrong(Text::tr("The file is cut: META_STOP is missing."));
        case Part::Start:
        case Part::Header:
            break;
    }
    return wrong(Text::tr("The file has no META_START and no rows."));
}

}  // namespace boresight::tables

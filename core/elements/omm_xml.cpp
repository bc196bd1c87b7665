// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/omm_xml.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/elements/omm_record.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <string>

namespace boresight::orbit {

namespace {

constexpr int kDeepest = 32;  // a valid message has 7 levels

class OmmXmlReader
{
public:
    explicit OmmXmlReader(std::string_view text)
        : m_xml(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())))
    {}

    ElementList read()
    {
        while (!m_xml.atEnd() && !m_list.isHopeless()) {
            take(m_xml.readNext());
        }
        if (m_xml.hasError()) {
            m_list.addProblem(line(), Text::tr("This is not valid XML: %1").arg(printable(m_xml.errorString())));
        } else if (!m_isFound) {
            m_list.addProblem(1, Text::tr("The XML has no element <omm>."));
        }
        return std::move(m_list);
    }

private:
    [[nodiscard]] int line() const { return std::max(1, static_cast<int>(m_xml.lineNumber())); }

    void take(QXmlStreamReader::TokenType token)
    {
        // The reader keeps every open element in memory, so a file of nothing but opening tags is rejected.
        m_depth += token == QXmlStreamReader::StartElement ? 1 : token == QXmlStreamReader::EndElement ? -1 : 0;
        if (m_depth > kDeepest) {
            m_xml.raiseError(Text::tr("More than %1 elements stand inside one another.").arg(kDeepest));
        }
        const bool isRecord = m_xml.name() == QLatin1String("omm");
        if (token == QXmlStreamReader::StartElement) {
            m_value.clear();
            if (isRecord) {
                m_isFound = true;
                m_record = {};
                m_record.set("", "", line());
            }
        } else if (token == QXmlStreamReader::Characters) {
            m_value += m_xml.text();
        } else if (token == QXmlStreamReader::EndElement && isRecord) {
            m_record.addTo(m_list);
        } else if (token == QXmlStreamReader::EndElement) {
            m_record.set(m_xml.name().toString().toStdString(), m_value.toStdString(), line());
            m_value.clear();
        }
    }

    QXmlStreamReader m_xml;
    ElementList m_list;
    OmmRecord m_record;
    QString m_value;
    bool m_isFound = false;
    int m_depth = 0;
};

}  // namespace

ElementList readOmmXml(std::string_view text)
{
    return OmmXmlReader(text).read();
}

}  // namespace boresight::orbit

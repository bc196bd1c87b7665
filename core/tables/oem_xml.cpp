// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_xml.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/tables/oem_parts.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace boresight::tables {
namespace {

// The elements of a row in the order of the KVN form. The accelerations may be missing.
constexpr std::array<QStringView, 10> kColumns{u"EPOCH", u"X",     u"Y",      u"Z",      u"X_DOT",
                                               u"Y_DOT", u"Z_DOT", u"X_DDOT", u"Y_DDOT", u"Z_DDOT"};
constexpr std::size_t kColumnsWithoutAccelerations = 7;
constexpr int kDeepest = 32;  // a valid message has 7 levels

tl::unexpected<Error> badXml(const QString& reason)
{
    return failure(ErrorCode::InvalidInput, reason);
}

class OemXmlReader
{
public:
    explicit OemXmlReader(std::string_view text)
        : m_xml(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()))),
          m_lastLine(std::ranges::count(text, '\n') + 1)
    {}

    TableReading<Oem> read()
    {
        Result<> taken = root();
        if (m_xml.hasError()) {
            taken = badXml(Text::tr("This is not valid XML: %1").arg(printable(m_xml.errorString())));
        }
        if (!taken) {
            return tl::unexpected(TableProblem{.line = line(), .reason = taken.error().text});
        }
        return std::move(m_parts.oem());
    }

private:
    // The XML reader also counts a CR inside a line, so the number is limited.
    [[nodiscard]] int line() const { return static_cast<int>(std::clamp<qint64>(m_xml.lineNumber(), 1, m_lastLine)); }
    Result<> root();
    Result<> message();
    Result<> segment();
    Result<> entries();
    Result<> rows();
    Result<> row();
    std::string value();
    void skip();

    // Calls `take` for each element inside the present one. `take` reads the element to its end. Comments are skipped.
    template <class Take>
    Result<> eachInside(const Take& take)
    {
        while (m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("COMMENT")) {
                skip();
            } else if (const Result<> taken = take(m_xml.name().toString()); !taken) {
                return taken;
            }
        }
        return {};
    }
    [[nodiscard]] static Result<> misplaced(const QString& name)
    {
        return badXml(Text::tr("The element <%1> has no place here in an OEM.").arg(orbit::quoted(name.toStdString())));
    }

    QXmlStreamReader m_xml;
    qint64 m_lastLine;
    OemParts m_parts;
    bool m_isFound = false;
};

Result<> OemXmlReader::root()
{
    m_xml.readNextStartElement();
    const auto takeMessage = [this](const QString& name) {
        if (name == QLatin1String("MESSAGE_ID")) {
            skip();
            return Result<>();
        }
        return name == QLatin1String("oem")
                   ? message()
                   : badXml(Text::tr("The file has an element <%1>. Boresight tracks only <oem>.")
                                .arg(orbit::quoted(name.toStdString())));
    };
    const Result<> taken =
        m_xml.name() == QLatin1String("ndm") ? eachInside(takeMessage) : takeMessage(m_xml.name().toString());
    while (taken && !m_xml.atEnd()) {
        m_xml.readNext();
    }
    return taken.and_then([this] { return m_xml.hasError() ? Result<>() : m_parts.end(); });
}

Result<> OemXmlReader::message()
{
    if (std::exchange(m_isFound, true)) {
        return badXml(Text::tr("The file has a second <oem>. Make two files."));
    }
    const std::string version = m_xml.attributes().value(QLatin1String("version")).toString().toStdString();
    return m_parts.take(std::string(kOemStart) + " = " + version).and_then([this] {
        return eachInside([this](const QString& name) {
            if (name == QLatin1String("header")) {
                return entries();
            }
            return name != QLatin1String("body") ? misplaced(name) : eachInside([this](const QString& inBody) {
                return inBody == QLatin1String("segment") ? segment() : misplaced(inBody);
            });
        });
    });
}

Result<> OemXmlReader::segment()
{
    bool hasMeta = false;
    return eachInside([&](const QString& name) {
        if (name == QLatin1String("metadata") && !std::exchange(hasMeta, true)) {
            return m_parts.take("META_START").and_then([this] { return entries(); }).and_then([this] {
                return m_parts.take("META_STOP");
            });
        }
        return name == QLatin1String("data") && hasMeta ? rows() : misplaced(name);
    });
}

Result<> OemXmlReader::entries()
{
    return eachInside([this](const QString& name) { return m_parts.take(name.toStdString() + " = " + value()); });
}

Result<> OemXmlReader::rows()
{
    return eachInside([this](const QString& name) {
        if (name == QLatin1String("covarianceMatrix")) {
            skip();
            return Result<>();
        }
        return name == QLatin1String("stateVector") ? row() : misplaced(name);
    });
}

Result<> OemXmlReader::row()
{
    std::array<std::string, kColumns.size()> texts;
    const Result<> taken = eachInside([&](const QString& name) {
        const auto column =
            static_cast<std::size_t>(std::find(kColumns.begin(), kColumns.end(), QStringView(name)) - kColumns.begin());
        if (column == kColumns.size() || !texts[column].empty()) {
            return misplaced(name);
        }
        texts[column] = value();
        return !texts[column].empty() && texts[column].find_first_of(" \t\r\n") == std::string::npos
                   ? Result<>()
                   : badXml(Text::tr("%1 is \"%2\". It must be one value.").arg(name, orbit::quoted(texts[column])));
    });
    if (!taken || m_xml.hasError()) {
        return taken;
    }
    const auto last =
        std::ranges::all_of(texts.begin() + kColumnsWithoutAccelerations, texts.end(), &std::string::empty)
            ? texts.begin() + kColumnsWithoutAccelerations
            : texts.end();
    if (const auto missing = std::find(texts.begin(), last, std::string()); missing != last) {
        return badXml(
            Text::tr("The row has no <%1>.").arg(kColumns[static_cast<std::size_t>(missing - texts.begin())]));
    }
    std::string line;
    std::for_each(texts.begin(), last, [&line](const std::string& text) { line += text + ' '; });
    return m_parts.take(trimmed(line));
}

// The text of the present element. Reads to its end.
std::string OemXmlReader::value()
{
    return std::string(trimmed(m_xml.readElementText().toStdString()));
}

// Skips the present element to its end. The XML reader keeps every open element in memory, so a file of nothing but
// opening tags is rejected.
void OemXmlReader::skip()
{
    for (int depth = 1; depth > 0 && !m_xml.atEnd();) {
        m_xml.readNext();
        depth += m_xml.isStartElement() ? 1 : m_xml.isEndElement() ? -1 : 0;
        if (depth > kDeepest) {
            m_xml.raiseError(Text::tr("More than %1 elements stand inside one another.").arg(kDeepest));
        }
    }
}

}  // namespace

TableReading<Oem> readOemXml(std::string_view text)
{
    return OemXmlReader(text).read();
}

}  // namespace boresight::tables

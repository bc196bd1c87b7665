// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/omm_json.h"

#include "core/base/text.h"
#include "core/elements/element_check.h"
#include "core/elements/omm_record.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <optional>
#include <string>

namespace boresight::orbit {

namespace {

struct JsonSlice
{
    std::string_view text;
    int line = 0;
};

// Cuts the outermost objects out of a text, so that each is parsed separately and its line number is known.
class JsonObjects
{
public:
    explicit JsonObjects(std::string_view text) : m_text(text) {}

    // Empty at the end of the text.
    std::optional<JsonSlice> next()
    {
        for (; m_at < m_text.size(); ++m_at) {
            const char character = m_text[m_at];
            countLine(character);
            if (character == '{') {
                return object();
            }
            if (m_stray.line == 0 &&
                std::string_view("[], \t\r\n\xEF\xBB\xBF").find(character) == std::string_view::npos) {
                m_stray = {m_text.substr(m_at, m_text.find_first_of("{\n", m_at) - m_at), m_line};
            }
        }
        return std::nullopt;
    }

    // The first text outside of objects that is not JSON. Line 0: there is none.
    [[nodiscard]] const JsonSlice& stray() const { return m_stray; }

private:
    void countLine(char character) { m_line += character == '\n' ? 1 : 0; }

    // An object without an end reaches to the end of the text.
    JsonSlice object()
    {
        const std::size_t begin = m_at;
        const int line = m_line;
        int depth = 0;
        bool isText = false;
        for (; m_at < m_text.size(); ++m_at) {
            const char character = m_text[m_at];
            countLine(m_at == begin ? ' ' : character);
            if (isText) {
                m_at += character == '\\' ? 1 : 0;
                isText = character != '"' && character != '\n';  // a JSON string contains no line end
            } else if (character == '"') {
                isText = true;
            } else {
                depth += character == '{' ? 1 : character == '}' ? -1 : 0;
                if (depth == 0) {
                    ++m_at;
                    break;
                }
            }
        }
        m_at = std::min(m_at, m_text.size());
        return {m_text.substr(begin, m_at - begin), line};
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_line = 1;
    JsonSlice m_stray;
};

std::string valueText(const QJsonValue& value)
{
    constexpr int kAllDigits = 17;
    return value.isDouble() ? QByteArray::number(value.toDouble(), 'g', kAllDigits).toStdString()
                            : value.toString().toStdString();
}

void readObject(const JsonSlice& slice, ElementList& list)
{
    QJsonParseError error{};
    const auto bytes = QByteArray::fromRawData(slice.text.data(), static_cast<qsizetype>(slice.text.size()));
    const QJsonObject object = QJsonDocument::fromJson(bytes, &error).object();
    if (error.error != QJsonParseError::NoError) {
        list.addProblem(slice.line, Text::tr("This is not a JSON object: %1.").arg(error.errorString()));
        return;
    }
    OmmRecord record;
    record.set("", "", slice.line);
    for (auto field = object.begin(); field != object.end(); ++field) {
        record.set(field.key().toStdString(), valueText(field.value()), slice.line);
    }
    record.addTo(list);
}

}  // namespace

ElementList readOmmJson(std::string_view text)
{
    ElementList list;
    JsonObjects objects(text);
    for (auto slice = objects.next(); slice && !list.isHopeless(); slice = objects.next()) {
        readObject(*slice, list);
    }
    if (objects.stray().line > 0) {
        list.addProblem(objects.stray().line,
                        Text::tr("\"%1\" is not an element set in JSON.").arg(quoted(objects.stray().text)));
    }
    return list;
}

}  // namespace boresight::orbit

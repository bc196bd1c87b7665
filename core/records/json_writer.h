// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/records/field_list.h"
#include "core/records/iso_time.h"

#include <QJsonObject>
#include <QString>

#include <cstdint>
#include <string_view>

// Writes a record as a JSON object by the list of its fields (field_list.h). Doubles are stored exactly. Pure.
namespace boresight::records {

class JsonWriter
{
public:
    // An absent value is not written.
    [[nodiscard]] bool has(std::string_view, bool there) const { return there; }

    void number(std::string_view key, double value, Range) { insert(key, value); }
    void whole(std::string_view key, std::int64_t value, Range) { insert(key, static_cast<double>(value)); }
    void flag(std::string_view key, bool value) { insert(key, value); }
    void uuid(std::string_view key, const QString& value) { insert(key, value); }
    void uuidOrEmpty(std::string_view key, const QString& value) { insert(key, value); }
    void time(std::string_view key, UtcTime value) { insert(key, isoTime(value)); }

    template <class Value, class Fields>
    void table(std::string_view key, Value& value, Fields fields)
    {
        JsonWriter inner;
        fields(inner, value);
        insert(key, inner.written());
    }

    [[nodiscard]] const QJsonObject& written() const { return m_object; }

private:
    void insert(std::string_view key, const QJsonValue& value)
    {
        m_object.insert(QLatin1String(key.data(), static_cast<qsizetype>(key.size())), value);
    }

    QJsonObject m_object;
};

}  // namespace boresight::records

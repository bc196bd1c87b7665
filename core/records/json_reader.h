// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/records/field_list.h"

#include <QJsonObject>
#include <QString>

#include <cstdint>
#include <functional>
#include <string_view>

// Reads a record from a JSON object by the list of its fields (field_list.h), and keeps the first error. Unknown keys
// are ignored, because a checksum protects these files. Pure.
namespace boresight::records {

class JsonReader
{
public:
    // `name`: the name of the object in an error about one of its own fields. An error in an inner table has only the
    // name of the table.
    [[nodiscard]] static Result<> read(const QJsonObject& object, const QString& name,
                                       const std::function<void(JsonReader&)>& fields);

    [[nodiscard]] bool has(std::string_view key, bool) const;

    void number(std::string_view key, double& value, Range range);
    void whole(std::string_view key, std::int64_t& value, Range range);
    void flag(std::string_view key, bool& value);
    void uuid(std::string_view key, QString& value);
    void uuidOrEmpty(std::string_view key, QString& value);
    void time(std::string_view key, UtcTime& value);

    // Reads an inner table. An absent table counts as empty.
    template <class Value, class Fields>
    void table(std::string_view key, Value& value, Fields fields)
    {
        JsonReader inner = at(key);
        fields(inner, value);
    }

private:
    JsonReader(QJsonObject object, QString name, QString inner, QString& problem);

    [[nodiscard]] JsonReader at(std::string_view key) const;
    [[nodiscard]] QJsonValue valueOf(std::string_view key) const;
    void complain(std::string_view key, const QString& reason);

    QJsonObject m_object;
    QString m_name;
    QString m_inner;  // prefix of the names of its tables
    QString& m_problem;
};

}  // namespace boresight::records

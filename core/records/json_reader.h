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

// Reads a record from a JSON object by the list of its fields (field_list.h), and keeps the first thing that is wrong
// with it. An unknown key does no harm: a checksum guards these files. Pure.
namespace boresight::records {

class JsonReader
{
public:
    // `name`: what a problem of the object's own fields names it. Those of its tables are named by the tables alone.
    [[nodiscard]] static Result<> read(const QJsonObject& object, const QString& name,
                                       const std::function<void(JsonReader&)>& fields);

    [[nodiscard]] bool has(std::string_view key, bool) const;

    void number(std::string_view key, double& value, Range range);
    void whole(std::string_view key, std::int64_t& value, Range range);
    void flag(std::string_view key, bool& value);
    void uuid(std::string_view key, QString& value);
    void uuidOrEmpty(std::string_view key, QString& value);
    void time(std::string_view key, UtcTime& value);

    // One that is absent has no fields.
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
    QString m_inner;  // before the names of its tables
    QString& m_problem;
};

}  // namespace boresight::records

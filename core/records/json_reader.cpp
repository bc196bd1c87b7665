// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/records/json_reader.h"

#include "core/base/text.h"
#include "core/records/iso_time.h"

#include <QDateTime>
#include <QRegularExpression>

#include <chrono>
#include <cmath>
#include <utility>

namespace boresight::records {
namespace {

constexpr std::chrono::sys_days kFirstDay{std::chrono::year{1970} / 1 / 1};  // a clock without a battery starts here
constexpr std::chrono::sys_days kLastDay{std::chrono::year{2200} / 1 / 1};

bool isUuid(const QString& text)
{
    static const QRegularExpression pattern(
        QStringLiteral(R"(\A[0-9a-fA-F]{8}-([0-9a-fA-F]{4}-){3}[0-9a-fA-F]{12}\z)"));
    return pattern.match(text).hasMatch();
}

}  // namespace

JsonReader::JsonReader(QJsonObject object, QString name, QString inner, QString& problem)
    : m_object(std::move(object)), m_name(std::move(name)), m_inner(std::move(inner)), m_problem(problem)
{}

Result<> JsonReader::read(const QJsonObject& object, const QString& name,
                          const std::function<void(JsonReader&)>& fields)
{
    QString problem;
    JsonReader reader(object, name, QString(), problem);
    fields(reader);
    if (!problem.isEmpty()) {
        return failure(ErrorCode::OutOfRange, problem);
    }
    return {};
}

bool JsonReader::has(std::string_view key, bool) const
{
    return !valueOf(key).isUndefined();
}

void JsonReader::number(std::string_view key, double& value, Range range)
{
    const QJsonValue found = valueOf(key);
    const double number = found.toDouble();
    if (found.isNull() || !std::isfinite(number)) {  // JSON has no NaN, so it is written as null
        complain(key, Text::tr("%1 is not finite"));
    } else if (!found.isDouble()) {
        complain(key, Text::tr("%1 is not a number"));
    } else if (number < range.min || number > range.max) {
        complain(key, Text::tr("%1 is out of range"));
    } else {
        value = number;
    }
}

void JsonReader::whole(std::string_view key, std::int64_t& value, Range range)
{
    auto found = static_cast<double>(value);
    number(key, found, range);
    if (found != std::floor(found)) {
        complain(key, Text::tr("%1 is not a whole number"));
    } else {
        value = static_cast<std::int64_t>(found);
    }
}

void JsonReader::flag(std::string_view key, bool& value)
{
    const QJsonValue found = valueOf(key);
    if (!found.isBool()) {
        complain(key, Text::tr("%1 is neither true nor false"));
    }
    value = found.toBool();
}

void JsonReader::uuid(std::string_view key, QString& value)
{
    value = valueOf(key).toString();
    if (!isUuid(value)) {
        complain(key, Text::tr("%1 is not of the form 8-4-4-4-12 digits"));
    }
}

void JsonReader::uuidOrEmpty(std::string_view key, QString& value)
{
    const QJsonValue found = valueOf(key);
    if (found.isString() && found.toString().isEmpty()) {
        value.clear();
    } else {
        uuid(key, value);
    }
}

void JsonReader::time(std::string_view key, UtcTime& value)
{
    const QString text = valueOf(key).toString();
    const QDateTime parsed = QDateTime::fromString(text, Qt::ISODateWithMs);
    const auto found = std::chrono::sys_time<std::chrono::milliseconds>(
        std::chrono::milliseconds(parsed.isValid() ? parsed.toMSecsSinceEpoch() : 0));
    if (!parsed.isValid() || found < kFirstDay || found > kLastDay || isoTime(found) != text) {
        complain(key, Text::tr("%1 is not a UTC time from 1970 to 2200"));
    } else {
        value = found;
    }
}

JsonReader JsonReader::at(std::string_view key) const
{
    const QString path = m_inner + toQString(key);
    return {valueOf(key).toObject(), path, path + u'.', m_problem};
}

QJsonValue JsonReader::valueOf(std::string_view key) const
{
    return m_object.value(QLatin1String(key.data(), static_cast<qsizetype>(key.size())));
}

void JsonReader::complain(std::string_view key, const QString& reason)
{
    if (m_problem.isEmpty()) {
        m_problem = reason.arg(m_name + u'.' + toQString(key));
    }
}

}  // namespace boresight::records

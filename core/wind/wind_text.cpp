// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_text.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <optional>

namespace boresight::wind {
namespace {

constexpr std::string_view kWord = "wind";

double metresPerSecond(double speed, Unit unit)
{
    switch (unit) {
        case Unit::MetresPerSecond:
            break;
        case Unit::KilometresPerHour:
            return speed / 3.6;
        case Unit::Knots:
            return speed * 1852.0 / 3600.0;
    }
    return speed;
}

Result<double> checked(const std::optional<double>& speed, Unit unit)
{
    if (!speed) {
        return failure(ErrorCode::InvalidInput, Text::tr("the wind speed is not a number"));
    }
    const double converted = metresPerSecond(*speed, unit);
    if (!(converted >= 0.0 && converted <= kStrongest)) {
        return failure(ErrorCode::OutOfRange, Text::tr("the wind speed is not within 0 to 150 m/s"));
    }
    return converted;
}

Result<double> ofLine(const QByteArray& line, const Format& format)
{
    const QList<QByteArray> words = line.simplified().split(' ');
    const std::string first = words.front().toStdString();
    const bool isNamed = words.size() == 2 && (first == format.key || first == kWord);
    if (words.size() != 1 && !isNamed) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a number, \"wind\" and a number, or a JSON object is expected"));
    }
    return checked(parseFinite(words.back().toStdString()), format.unit);
}

// A field with the complete key is used before nested objects.
QJsonValue valueOf(const QJsonObject& object, const QString& key)
{
    if (object.contains(key)) {
        return object[key];
    }
    QJsonValue value = object;
    for (const QString& step : key.split(QLatin1Char('.'))) {
        value = value.toObject()[step];
    }
    return value;
}

Result<double> ofObject(const QByteArray& text, const Format& format)
{
    const QJsonDocument document = QJsonDocument::fromJson(text);
    if (!document.isObject()) {
        return failure(ErrorCode::InvalidInput, Text::tr("the text is not a JSON object"));
    }
    const QString key = toQString(format.key);
    const QJsonValue value = valueOf(document.object(), key);
    if (value.isUndefined()) {
        return failure(ErrorCode::InvalidInput, Text::tr("the object has no \"%1\" (wind.key)").arg(key));
    }
    if (value.isString()) {
        return checked(parseFinite(value.toString().trimmed().toStdString()), format.unit);
    }
    return checked(value.isDouble() ? std::optional(value.toDouble()) : std::nullopt, format.unit);
}

}  // namespace

Result<double> readWind(std::string_view text, const Format& format)
{
    if (text.size() > kLongestReading) {
        return failure(ErrorCode::InvalidInput, Text::tr("the message is longer than 4096 bytes"));
    }
    const QByteArray line = QByteArray(text.data(), static_cast<qsizetype>(text.size())).trimmed();
    return line.startsWith('{') ? ofObject(line, format) : ofLine(line, format);
}

}  // namespace boresight::wind

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/position/position_text.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <vector>

namespace boresight::position {
namespace {

using Milliseconds = std::chrono::milliseconds;

constexpr double kDeepest = -1000.0;      // m
constexpr double kHighest = 2'000'000.0;  // m, above the highest sounding rockets
constexpr qsizetype kLongestName = 40;

tl::unexpected<Error> refused(const QString& reason)
{
    return failure(ErrorCode::InvalidInput, reason);
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// The time of day in "12:06:04", "12:06:04.5Z" or "2026-11-27T12:06:04+00:00". Empty for any other text.
std::optional<Milliseconds> timeOfDay(std::string_view text)
{
    text = text.substr(text.find('T') == std::string_view::npos ? 0 : text.find('T') + 1);
    text = text.substr(0, text.find_first_of("Z+"));
    if (text.size() < 8 || text[2] != ':' || text[5] != ':') {
        return std::nullopt;
    }
    const auto hours = parseInteger(text.substr(0, 2));
    const auto minutes = parseInteger(text.substr(3, 2));
    const auto seconds = parseFinite(text.substr(6));
    if (!hours || !minutes || !seconds || *hours < 0 || *hours > 23 || *minutes < 0 || *minutes > 59 ||
        *seconds < 0.0 || *seconds >= 60.0) {
        return std::nullopt;
    }
    return std::chrono::hours(*hours) + std::chrono::minutes(*minutes) +
           Milliseconds(static_cast<int>(std::floor(*seconds * 1e3)));
}

Result<PositionText> placed(double latitude, double longitude, double height)
{
    if (!(std::abs(latitude) <= 90.0)) {
        return refused(Text::tr("the latitude is not within ±90°"));
    }
    if (!(longitude >= -180.0 && longitude <= 360.0)) {
        return refused(Text::tr("the longitude is not within -180° to 360°"));
    }
    if (!(height >= kDeepest && height <= kHighest)) {
        return refused(Text::tr("the height is not within -1000 m to 2000000 m"));
    }
    if (latitude == 0.0 && longitude == 0.0) {
        return refused(Text::tr("latitude and longitude are 0, as without a GPS fix"));
    }
    return PositionText{.site = {.latitude = Angle::fromDegrees(latitude),
                                 .longitude = Angle::fromDegrees(longitude > 180.0 ? longitude - 360.0 : longitude),
                                 .heightMetres = height}};
}

Result<PositionText> fromLine(std::string_view text)
{
    std::vector<std::string_view> parts;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        parts.push_back(trimmed(rest.substr(0, comma)));
        if (comma == std::string_view::npos || parts.size() > 4) {
            break;
        }
        rest.remove_prefix(comma + 1);
    }
    if (parts.size() != 3 && parts.size() != 4) {
        return refused(Text::tr("\"LATITUDE,LONGITUDE,METRES\" or a JSON object is expected"));
    }
    const auto latitude = parseFinite(parts[0]);
    const auto longitude = parseFinite(parts[1]);
    const auto height = parseFinite(parts[2]);
    if (!latitude || !longitude || !height) {
        return refused(Text::tr("a part of the line is not a number"));
    }
    Result<PositionText> read = placed(*latitude, *longitude, *height);
    if (read && parts.size() == 4) {
        read->time = timeOfDay(parts[3]);
        if (!read->time) {
            return refused(Text::tr("the time is not HH:MM:SS"));
        }
    }
    return read;
}

// The value of the long name, or else that of the short one.
std::optional<double> numberOf(const QJsonObject& object, const QString& name, qsizetype shortened)
{
    const QJsonValue value = object.contains(name) ? object[name] : object[name.left(shortened)];
    if (value.isString()) {
        return parseFinite(value.toString().toStdString());
    }
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

Result<PositionText> fromJson(std::string_view text)
{
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size())));
    if (!document.isObject()) {
        return refused(Text::tr("the text is not a JSON object"));
    }
    const QJsonObject object = document.object();
    const QString type = QStringLiteral("type");
    if (object.contains(type) && object[type].toString() != QLatin1String("PAYLOAD_SUMMARY")) {
        return refused(Text::tr("the object is not a PAYLOAD_SUMMARY"));  // "GPS" is the chase car
    }
    const auto latitude = numberOf(object, QStringLiteral("latitude"), 3);
    const auto longitude = numberOf(object, QStringLiteral("longitude"), 3);
    const auto height = numberOf(object, QStringLiteral("altitude"), 3);
    if (!latitude || !longitude || !height) {
        return refused(Text::tr("the object has no latitude, longitude and altitude"));
    }
    return placed(*latitude, *longitude, *height).map([&](PositionText read) {
        const QString name = object[QStringLiteral("callsign")].toString();
        read.name = printable(name.simplified().left(kLongestName));
        read.time = timeOfDay(object[QStringLiteral("time")].toString().toStdString());
        return read;
    });
}

}  // namespace

Result<PositionText> readPosition(std::string_view text)
{
    if (text.size() > kLongestPosition) {
        return refused(Text::tr("the message is longer than 4096 bytes"));
    }
    text = trimmed(text);
    return text.starts_with('{') ? fromJson(text) : fromLine(text);
}

}  // namespace boresight::position

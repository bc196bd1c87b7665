// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/record_json.h"

#include "core/base/text.h"
#include "core/records/iso_time.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace boresight::recording {
namespace {

constexpr qsizetype kMostChannels = 256;
constexpr std::array kKindKeys{"event", "motion", "alarm", "client"};  // in the order of EventKind
constexpr std::array kLevelKeys{"advisory", "warning", "alarm"};       // in the order of EventLevel

QByteArray compact(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

std::optional<QJsonObject> objectIn(QByteArrayView json)
{
    const QJsonDocument document = QJsonDocument::fromJson(json.toByteArray());
    return document.isObject() ? std::optional(document.object()) : std::nullopt;
}

// Empty: this is no time, or one that no recording has.
std::optional<UtcTime> writtenTime(const QJsonValue& value)
{
    const QDateTime time = QDateTime::fromString(value.toString(), Qt::ISODateWithMs);
    constexpr qint64 kLatest = 9'200'000'000'000;  // of a clock of nanoseconds in 64 bits
    const qint64 ms = time.isValid() ? std::clamp(time.toMSecsSinceEpoch(), -kLatest, kLatest) : 0;
    const UtcTime utc{std::chrono::milliseconds(ms)};
    return isRecordable(utc) ? std::optional(utc) : std::nullopt;
}

// A text for terminal, window and report. A control character could move the cursor, or hide what follows.
QString writtenText(const QJsonValue& value)
{
    QString text = value.toString();
    for (QChar& one : text) {
        one = one.category() == QChar::Other_Control ? QChar(QChar::ReplacementCharacter) : one;
    }
    return text;
}

template <class Keys>
std::size_t indexOfKey(const Keys& keys, const QJsonValue& value)
{
    const QString text = value.toString();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (text == QLatin1String(keys[i])) {
            return i;
        }
    }
    return 0;
}

template <class Row>
QJsonArray channelList(const std::vector<Channel<Row>>& channels)
{
    QJsonArray list;
    for (const Channel<Row>& one : channels) {
        list.append(QJsonObject{{QStringLiteral("name"), toQString(one.name)},
                                {QStringLiteral("unit"), toQString(one.unit)},
                                {QStringLiteral("per_unit"), one.perUnit}});
    }
    return list;
}

std::optional<std::vector<WrittenChannel>> channelsIn(const QJsonObject& object)
{
    constexpr double kLeastSteps = 1e-6;
    constexpr double kMostSteps = 1e9;
    const QJsonArray list = object.value(QStringLiteral("channels")).toArray();
    std::vector<WrittenChannel> channels;
    for (const QJsonValue& one : list) {
        const double perUnit = one[QStringLiteral("per_unit")].toDouble();
        channels.push_back({.name = one[QStringLiteral("name")].toString(), .perUnit = perUnit});
        if (channels.back().name.isEmpty() || !(perUnit >= kLeastSteps && perUnit <= kMostSteps)) {
            return std::nullopt;
        }
    }
    return channels.empty() || list.size() > kMostChannels ? std::nullopt : std::optional(channels);
}

QJsonValue spanJson(const std::optional<plan::PlanSpan>& span)
{
    return span ? QJsonValue(QJsonArray{records::isoTime(span->from), records::isoTime(span->to)}) : QJsonValue();
}

std::optional<plan::PlanSpan> spanIn(const QJsonValue& value)
{
    const auto from = writtenTime(value[0]);
    const auto to = writtenTime(value[1]);
    return from && to ? std::optional(plan::PlanSpan{*from, *to}) : std::nullopt;
}

QStringList wordsIn(const QJsonValue& value)
{
    QStringList words;
    for (const QJsonValue& word : value.toArray()) {
        words.append(writtenText(word));
    }
    return words;
}

Angle degreesIn(const QJsonObject& object, QLatin1String key)
{
    return Angle::fromDegrees(object.value(key).toDouble());
}

plan::PlanWay wayOf(const QJsonValue& value)
{
    const QString key = value.toString();
    for (int i = 0; i <= static_cast<int>(plan::PlanWay::Unwraps); ++i) {
        if (plan::keyOf(static_cast<plan::PlanWay>(i)) == key) {
            return static_cast<plan::PlanWay>(i);
        }
    }
    return plan::PlanWay::Direct;
}

}  // namespace

QByteArray headerJson(const Header& header)
{
    QJsonObject object{{QStringLiteral("program"), header.program},
                       {QStringLiteral("mount"), header.mount},
                       {QStringLiteral("simulated"), header.isSimulated},
                       {QStringLiteral("beam_width_deg"), header.beamWidth.degrees()},
                       {QStringLiteral("target"), header.target},
                       {QStringLiteral("client"), header.client},
                       {QStringLiteral("began"), records::isoTime(header.began)},
                       {QStringLiteral("part"), header.part},
                       {QStringLiteral("state_words"), QJsonArray::fromStringList(header.stateWords)},
                       {QStringLiteral("axis_words"), QJsonArray::fromStringList(header.axisWords)},
                       {QStringLiteral("channels"), channelList(tickChannels())}};
    if (header.site) {
        object.insert(QStringLiteral("site"),
                      QJsonObject{{QStringLiteral("latitude_deg"), header.site->latitude.degrees()},
                                  {QStringLiteral("longitude_deg"), header.site->longitude.degrees()},
                                  {QStringLiteral("height_m"), header.site->heightMetres}});
    }
    if (header.number) {
        object.insert(QStringLiteral("number"), static_cast<qint64>(*header.number));
    }
    return compact(object);
}

std::optional<Described<Header>> readHeaderJson(QByteArrayView json)
{
    const auto object = objectIn(json);
    const auto channels = object ? channelsIn(*object) : std::nullopt;
    if (!channels) {
        return std::nullopt;
    }
    const auto textAt = [&object](QLatin1String key) { return writtenText(object->value(key)); };
    Header header{.program = textAt(QLatin1String("program")),
                  .mount = textAt(QLatin1String("mount")),
                  .isSimulated = object->value(QLatin1String("simulated")).toBool(),
                  .beamWidth = degreesIn(*object, QLatin1String("beam_width_deg")),
                  .target = textAt(QLatin1String("target")),
                  .client = textAt(QLatin1String("client")),
                  .began = writtenTime(object->value(QLatin1String("began"))).value_or(UtcTime()),
                  .part = object->value(QLatin1String("part")).toInt(1),
                  .stateWords = wordsIn(object->value(QLatin1String("state_words"))),
                  .axisWords = wordsIn(object->value(QLatin1String("axis_words")))};
    if (const QJsonValue site = object->value(QLatin1String("site")); site.isObject()) {
        const QJsonObject place = site.toObject();
        header.site = Site{.latitude = degreesIn(place, QLatin1String("latitude_deg")),
                           .longitude = degreesIn(place, QLatin1String("longitude_deg")),
                           .heightMetres = place.value(QLatin1String("height_m")).toDouble()};
    }
    if (const QJsonValue number = object->value(QLatin1String("number")); number.isDouble()) {
        header.number = number.toInteger();
    }
    return Described<Header>{.value = header, .channels = *channels};
}

QByteArray eventsJson(std::span<const Event> events)
{
    QJsonArray list;
    for (const Event& one : events) {
        list.append(
            QJsonObject{{QStringLiteral("utc"), records::isoTime(one.utc)},
                        {QStringLiteral("kind"), QLatin1String(kKindKeys.at(static_cast<std::size_t>(one.kind)))},
                        {QStringLiteral("level"), QLatin1String(kLevelKeys.at(static_cast<std::size_t>(one.level)))},
                        {QStringLiteral("source"), one.source},
                        {QStringLiteral("text"), one.text}});
    }
    return QJsonDocument(list).toJson(QJsonDocument::Compact);
}

std::optional<std::vector<Event>> readEventsJson(QByteArrayView json)
{
    const QJsonDocument document = QJsonDocument::fromJson(json.toByteArray());
    if (!document.isArray()) {
        return std::nullopt;
    }
    std::vector<Event> events;
    for (const QJsonValue& one : document.array()) {
        const auto utc = writtenTime(one[QStringLiteral("utc")]);
        if (!utc) {
            return std::nullopt;
        }
        events.push_back({.utc = *utc,
                          .kind = static_cast<EventKind>(indexOfKey(kKindKeys, one[QStringLiteral("kind")])),
                          .level = static_cast<EventLevel>(indexOfKey(kLevelKeys, one[QStringLiteral("level")])),
                          .source = writtenText(one[QStringLiteral("source")]),
                          .text = writtenText(one[QStringLiteral("text")])});
    }
    return events;
}

QByteArray gapJson(const Gap& gap)
{
    return compact({{QStringLiteral("from"), records::isoTime(gap.from)},
                    {QStringLiteral("to"), records::isoTime(gap.to)},
                    {QStringLiteral("ticks"), static_cast<qint64>(gap.ticks)}});
}

std::optional<Gap> readGapJson(QByteArrayView json)
{
    const auto object = objectIn(json);
    if (!object) {
        return std::nullopt;
    }
    const auto from = writtenTime(object->value(QLatin1String("from")));
    const auto to = writtenTime(object->value(QLatin1String("to")));
    if (!from || !to) {
        return std::nullopt;
    }
    const qint64 ticks = object->value(QLatin1String("ticks")).toInteger();
    return Gap{.from = *from, .to = *to, .ticks = static_cast<std::uint64_t>(std::max<qint64>(ticks, 0))};
}

QByteArray planJson(const plan::PlanVariant& plan)
{
    const plan::Forecast& forecast = plan.forecast;
    QJsonObject object{{QStringLiteral("way"), plan::keyOf(plan.way)},
                       {QStringLiteral("peak_deg"), forecast.peak.degrees()},
                       {QStringLiteral("rms_deg"), forecast.rms.degrees()},
                       {QStringLiteral("beyond_s"), forecast.beyond.count()},
                       {QStringLiteral("hidden_s"), forecast.hidden.count()},
                       {QStringLiteral("to_start_s"), plan.toStart.count()},
                       {QStringLiteral("margin_deg"), plan.margin.degrees()},
                       {QStringLiteral("ramp"), spanJson(plan.ramp)},
                       {QStringLiteral("unwrap"), spanJson(plan.unwrap)},
                       {QStringLiteral("channels"), channelList(planChannels())}};
    if (forecast.peakLoss) {
        object.insert(QStringLiteral("peak_db"), *forecast.peakLoss);
    }
    return compact(object);
}

std::optional<Described<plan::PlanVariant>> readPlanJson(QByteArrayView json)
{
    const auto object = objectIn(json);
    const auto channels = object ? channelsIn(*object) : std::nullopt;
    if (!channels) {
        return std::nullopt;
    }
    const auto seconds = [&object](QLatin1String key) { return Seconds(object->value(key).toDouble()); };
    plan::PlanVariant plan{.way = wayOf(object->value(QLatin1String("way"))),
                           .moments = {},
                           .forecast = {.peak = degreesIn(*object, QLatin1String("peak_deg")),
                                        .rms = degreesIn(*object, QLatin1String("rms_deg")),
                                        .beyond = seconds(QLatin1String("beyond_s")),
                                        .hidden = seconds(QLatin1String("hidden_s"))},
                           .ramp = spanIn(object->value(QLatin1String("ramp"))),
                           .unwrap = spanIn(object->value(QLatin1String("unwrap"))),
                           .toStart = seconds(QLatin1String("to_start_s")),
                           .margin = degreesIn(*object, QLatin1String("margin_deg"))};
    if (const QJsonValue loss = object->value(QLatin1String("peak_db")); loss.isDouble()) {
        plan.forecast.peakLoss = loss.toDouble();
    }
    return Described<plan::PlanVariant>{.value = std::move(plan), .channels = *channels};
}

}  // namespace boresight::recording

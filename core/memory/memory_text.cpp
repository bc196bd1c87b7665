// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/memory_text.h"

#include "core/base/text.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::memory {
namespace {

constexpr int kVersion = 1;
const QString kVersionKey = QStringLiteral("boresight_memory");
const QString kChecksumKey = QStringLiteral("checksum");
const QString kMemoryKey = QStringLiteral("memory");
const std::array<QString, 2> kAxisKeys = {QStringLiteral("azimuth"), QStringLiteral("elevation")};
const QString kTurnKey = QStringLiteral("turn");
const QString kCrashStopKey = QStringLiteral("crash_stop");
constexpr const char* kPlaceUsedKey = "entered_place_used";

// Absent together: the drive did not tell.
constexpr const char* kOriginBeginning = "origin_beginning";
constexpr const char* kOriginOffset = "origin_offset_turns";

// Wide on purpose: they refuse what is broken, not what is unusual.
constexpr double kLargestAngle = 1000.0 * 2.0 * std::numbers::pi;
constexpr double kLargestRate = 100.0 * 2.0 * std::numbers::pi;  // per second
constexpr double kLargestCount = 32768.0;                        // turns; a moteus starts again there
constexpr double kLargestCounted = (kLargestCount + 2.0) * 2.0 * std::numbers::pi;
constexpr double kLargestBeginning = 16777215.0;                             // three bytes
constexpr double kLargestOffset = 2.0 * kLargestCount;                       // turns
constexpr double kLargestUptime = 4294967.296;                               // s: a moteus counts 2^32 ms
constexpr double kLargestSinceBoot = 1e10;                                   // s
constexpr double kLargestStop = 3600.0 * 1000.0;                             // ms
constexpr std::chrono::sys_days kEarliest{std::chrono::year{1970} / 1 / 1};  // where a clock without battery starts
constexpr std::chrono::sys_days kLatest{std::chrono::year{2200} / 1 / 1};

QString inIso(UtcTime time)
{
    const auto sinceEpoch = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODateWithMs);
}

bool isUuid(const QString& text)
{
    static const QRegularExpression pattern(
        QStringLiteral(R"(\A[0-9a-fA-F]{8}-([0-9a-fA-F]{4}-){3}[0-9a-fA-F]{12}\z)"));
    return pattern.match(text).hasMatch();
}

// Takes one object apart and keeps the first thing that is wrong with it.
class Fields
{
public:
    // `path`: where the object is in the file, as complaints name it.
    Fields(const QJsonObject& object, const QString& path) : m_object(object), m_path(path) {}

    [[nodiscard]] bool has(const char* key) const { return m_object.contains(QLatin1String(key)); }

    double number(const char* key, double min, double max)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        const double found = value.toDouble();
        if (value.isNull() || !std::isfinite(found)) {  // JSON has no NaN: it is written as null
            complain(key, Text::tr("%1 is not finite"));
        } else if (!value.isDouble()) {
            complain(key, Text::tr("%1 is not a number"));
        } else if (found < min || found > max) {
            complain(key, Text::tr("%1 is out of range"));
        }
        return found;
    }

    int choice(const char* key, int count)
    {
        const double found = number(key, 0, count - 1);
        return static_cast<int>(whole(key, found));
    }

    double whole(const char* key, double found)
    {
        if (m_problem.isEmpty() && found != std::floor(found)) {
            complain(key, Text::tr("%1 is not a whole number"));
        }
        return m_problem.isEmpty() ? found : 0.0;
    }

    bool flag(const char* key)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        if (!value.isBool()) {
            complain(key, Text::tr("%1 is neither true nor false"));
        }
        return value.toBool();
    }

    QString uuid(const char* key, bool mayBeEmpty = false)
    {
        const QJsonValue value = m_object.value(QLatin1String(key));
        const QString text = value.toString();
        if (!value.isString() || !(isUuid(text) || (mayBeEmpty && text.isEmpty()))) {
            complain(key, Text::tr("%1 is not of the form 8-4-4-4-12 digits"));
        }
        return text;
    }

    UtcTime time(const char* key)
    {
        const QString text = m_object.value(QLatin1String(key)).toString();
        const QDateTime parsed = QDateTime::fromString(text, Qt::ISODateWithMs);
        const auto found = std::chrono::sys_time<std::chrono::milliseconds>(
            std::chrono::milliseconds(parsed.isValid() ? parsed.toMSecsSinceEpoch() : 0));
        if (!parsed.isValid() || found < kEarliest || found > kLatest || inIso(found) != text) {
            complain(key, Text::tr("%1 is not a UTC time from 1970 to 2200"));
            return {};
        }
        return found;
    }

    [[nodiscard]] const QString& problem() const { return m_problem; }

private:
    void complain(const char* key, const QString& reason)
    {
        if (m_problem.isEmpty()) {
            m_problem = reason.arg(m_path + u'.' + QLatin1String(key));
        }
    }

    QJsonObject m_object;
    QString m_path;
    QString m_problem;
};

QJsonObject toJson(const TurnRecord& record)
{
    QJsonObject json{{QStringLiteral("drive"), record.drive},
                     {QStringLiteral("angle_rad"), record.angle.radians()},
                     {QStringLiteral("reported_turns"), record.reported.turns()},
                     {QStringLiteral("counted_rad"), record.counted.radians()},
                     {QStringLiteral("uptime_s"), record.uptime.count()},
                     {QStringLiteral("home_state"), static_cast<int>(record.homeState)},
                     {QStringLiteral("when"), inIso(record.when)},
                     {QStringLiteral("host_boot"), record.host.boot},
                     {QStringLiteral("host_since_boot_s"), record.host.sinceBoot.count()},
                     {QStringLiteral("host_utc_is_exact"), record.host.utcIsExact},
                     {QStringLiteral("moving"), record.moving}};
    if (record.origin) {
        json.insert(QLatin1String(kOriginBeginning), static_cast<double>(record.origin->beginning));
        json.insert(QLatin1String(kOriginOffset), record.origin->offset.turns());
    }
    return json;
}

QJsonObject toJson(const CrashStop& stop)
{
    return {{QStringLiteral("drive"), stop.drive},
            {QStringLiteral("rate_rad_s"), stop.rate.radians()},
            {QStringLiteral("angle_rad"), stop.angle.radians()},
            {QStringLiteral("time_ms"), static_cast<double>(stop.time.count())},
            {QStringLiteral("when"), inIso(stop.when)}};
}

TurnRecord readTurn(Fields& fields)
{
    TurnRecord record;
    record.drive = fields.uuid("drive");
    record.angle = Angle::fromRadians(fields.number("angle_rad", -kLargestAngle, kLargestAngle));
    record.reported = MotorTurns::fromTurns(fields.number("reported_turns", -kLargestCount, kLargestCount));
    record.counted = Angle::fromRadians(fields.number("counted_rad", -kLargestCounted, kLargestCounted));
    record.uptime = Seconds(fields.number("uptime_s", 0.0, kLargestUptime));
    record.homeState = static_cast<moteus::HomeState>(fields.choice("home_state", 3));
    record.when = fields.time("when");
    record.host = {.boot = fields.uuid("host_boot", true),
                   .sinceBoot = Seconds(fields.number("host_since_boot_s", 0.0, kLargestSinceBoot)),
                   .utcIsExact = fields.flag("host_utc_is_exact")};
    record.moving = fields.flag("moving");
    if (fields.has(kOriginBeginning) || fields.has(kOriginOffset)) {
        const double beginning = fields.number(kOriginBeginning, 0.0, kLargestBeginning);
        record.origin = {
            .beginning = static_cast<std::uint32_t>(fields.whole(kOriginBeginning, beginning)),
            .offset = MotorTurns::fromTurns(fields.number(kOriginOffset, -kLargestOffset, kLargestOffset))};
    }
    return record;
}

CrashStop readCrashStop(Fields& fields)
{
    CrashStop stop;
    stop.drive = fields.uuid("drive");
    stop.rate = AngularRate::fromRadians(fields.number("rate_rad_s", -kLargestRate, kLargestRate));
    stop.angle = Angle::fromRadians(fields.number("angle_rad", -kLargestAngle, kLargestAngle));
    const double time = fields.whole("time_ms", fields.number("time_ms", 0.0, kLargestStop));
    stop.time = std::chrono::milliseconds(static_cast<std::chrono::milliseconds::rep>(time));
    stop.when = fields.time("when");
    return stop;
}

// Absent is a good answer: the axis was never journalled, or never proved.
template <class Value>
Result<std::optional<Value>> readOptional(const QJsonObject& payload, const QString& axisKey, const QString& key,
                                          Value (*read)(Fields&))
{
    const QJsonObject axis = payload.value(axisKey).toObject();
    if (!axis.contains(key)) {
        return std::optional<Value>();
    }
    Fields fields(axis.value(key).toObject(), axisKey + u'.' + key);
    Value value = read(fields);
    if (!fields.problem().isEmpty()) {
        return failure(ErrorCode::OutOfRange, fields.problem());
    }
    return value;
}

Result<MountMemory> readMemory(const QJsonObject& payload)
{
    MountMemory memory;
    for (std::size_t i = 0; i < kAxisKeys.size(); ++i) {
        const auto turn = readOptional<TurnRecord>(payload, kAxisKeys[i], kTurnKey, readTurn);
        const auto stop = readOptional<CrashStop>(payload, kAxisKeys[i], kCrashStopKey, readCrashStop);
        if (!turn || !stop) {
            return tl::unexpected(turn ? stop.error() : turn.error());
        }
        memory.turns[i] = *turn;
        memory.crashStops[i] = *stop;
    }
    if (Fields fields(payload, kMemoryKey); fields.has(kPlaceUsedKey)) {
        memory.placeUsed = fields.time(kPlaceUsedKey);
        if (!fields.problem().isEmpty()) {
            return failure(ErrorCode::OutOfRange, fields.problem());
        }
    }
    return memory;
}

// Over the canonical form of what was read: spaces do not count, everything else does.
QString checksum(const QJsonObject& payload)
{
    const QByteArray text = QJsonDocument(payload).toJson(QJsonDocument::Compact);
    return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex());
}

Result<QJsonObject> readRoot(const QByteArray& text)
{
    const bool blank = std::all_of(text.begin(), text.end(), [](char c) { return c == '\0' || c == ' ' || c == '\n'; });
    if (blank) {  // a file system that lost power may leave nothing, or zeros
        return failure(ErrorCode::InvalidInput, Text::tr("it is empty"));
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text, &error);
    if (error.error != QJsonParseError::NoError) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("it is torn or damaged at byte %1: %2").arg(error.offset).arg(error.errorString()));
    }
    const QJsonObject root = document.object();
    if (!root.value(kVersionKey).isDouble()) {
        return failure(ErrorCode::InvalidInput, Text::tr("it is not the memory of a mount"));
    }
    return root;
}

}  // namespace

Result<QByteArray> toText(const MountMemory& memory)
{
    QJsonObject payload;
    for (std::size_t i = 0; i < kAxisKeys.size(); ++i) {
        QJsonObject axis;
        if (const auto& turn = memory.turns[i]) {
            axis.insert(kTurnKey, toJson(*turn));
        }
        if (const auto& stop = memory.crashStops[i]) {
            axis.insert(kCrashStopKey, toJson(*stop));
        }
        payload.insert(kAxisKeys[i], axis);
    }
    if (memory.placeUsed) {
        payload.insert(QLatin1String(kPlaceUsedKey), inIso(*memory.placeUsed));
    }
    return readMemory(payload).map([&](const MountMemory&) {
        const QJsonObject root{{kVersionKey, kVersion}, {kChecksumKey, checksum(payload)}, {kMemoryKey, payload}};
        return QJsonDocument(root).toJson(QJsonDocument::Indented);
    });
}

Result<MountMemory> parseMemory(const QByteArray& text)
{
    const Result<QJsonObject> root = readRoot(text);
    if (!root) {
        return tl::unexpected(root.error());
    }
    if (const double version = root->value(kVersionKey).toDouble(); version != kVersion) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("its version %1 is not known to this program, which reads version %2").arg(version).arg(kVersion));
    }
    const QJsonObject payload = root->value(kMemoryKey).toObject();
    if (root->value(kChecksumKey).toString() != checksum(payload)) {
        return failure(ErrorCode::InvalidInput, Text::tr("its checksum is wrong: it was changed or damaged"));
    }
    return readMemory(payload);
}

}  // namespace boresight::memory

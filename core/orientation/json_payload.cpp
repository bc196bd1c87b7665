// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/json_payload.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/orientation/fields.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <cmath>

namespace boresight::orientation {
namespace {

Parsed<QJsonObject> objectOf(const QByteArray& payload)
{
    const QJsonDocument document = QJsonDocument::fromJson(payload);
    return document.isObject() ? Parsed<QJsonObject>(document.object()) : refused(Refusal::NotJson);
}

// `field` is the name in the refusal.
Parsed<double> numberOf(const QJsonObject& object, QLatin1String key, const char* field)
{
    const QJsonValue value = object[key];
    if (value.isUndefined()) {
        return refused(Refusal::FieldCount, field);
    }
    return value.isDouble() ? Parsed<double>(value.toDouble()) : refused(Refusal::NotANumber, field);
}

// A JSON number is a double, which is exact up to 2^53. That is enough for turns and milliseconds.
Parsed<std::int64_t> exactly(double value, const char* field)
{
    constexpr double kExact = 9007199254740992.0;
    if (std::abs(value) > kExact) {
        return refused(Refusal::OutOfRange, field);
    }
    return value == std::floor(value) ? Parsed<std::int64_t>(static_cast<std::int64_t>(value))
                                      : refused(Refusal::NotANumber, field);
}

Parsed<std::int64_t> wholeOf(const QJsonObject& object, QLatin1String key, const char* field)
{
    return numberOf(object, key, field).and_then([field](double value) { return exactly(value, field); });
}

// The firmware writes this value as a string. Its documentation describes a number.
Parsed<UtcTime> sensorTimeOf(const QJsonObject& object)
{
    const QJsonValue value = object[QLatin1String("ts")];
    if (!value.isString()) {
        return wholeOf(object, QLatin1String("ts"), "time").and_then(&timeOf);
    }
    const auto milliseconds = parseInteger(value.toString().toStdString());
    return milliseconds ? timeOf(*milliseconds) : refused(Refusal::NotANumber, "time");
}

Parsed<int> digitOf(const QJsonObject& object, QLatin1String key)
{
    return wholeOf(object, key, "calibration").and_then(&calibrationDigitOf);
}

// The units may be missing. If present, they must be the known ones.
bool hasItsUnits(const QJsonObject& object)
{
    const QJsonObject units = object[QLatin1String("units")].toObject();
    const auto is = [&units](QLatin1String key, QLatin1String unit) {
        return !units.contains(key) || units[key].toString() == unit;
    };
    return is(QLatin1String("ts"), QLatin1String("milliseconds")) &&
           is(QLatin1String("orientation"), QLatin1String("decimal degrees"));
}

constexpr std::size_t kMostUnknown = 400;  // bytes: enough to read, too little to fill the memory

std::string unknownOf(QJsonObject object, std::initializer_list<const char*> known)
{
    for (const char* const one : known) {
        object.remove(QLatin1String(one));
    }
    return object.isEmpty()
               ? std::string()
               : printable(QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString().substr(0, kMostUnknown));
}

}  // namespace

Parsed<Orientation> parseOrientation(const QByteArray& payload, SteadyTime arrival)
{
    const auto object = objectOf(payload);
    if (!object) {
        return tl::unexpected(object.error());
    }
    if (!hasItsUnits(*object)) {
        return refused(Refusal::Unit);
    }
    const auto time = sensorTimeOf(*object);
    const auto azimuth = numberOf(*object, QLatin1String("azimuth"), "azimuth").and_then(&azimuthOf);
    const auto elevation = numberOf(*object, QLatin1String("elevation"), "elevation").and_then(&elevationOf);
    const auto revolutions = wholeOf(*object, QLatin1String("revolutions"), "revolutions");
    if (!time || !azimuth || !elevation || !revolutions) {
        return tl::unexpected(!time        ? time.error()
                              : !azimuth   ? azimuth.error()
                              : !elevation ? elevation.error()
                                           : revolutions.error());
    }
    return Orientation{
        .heading = SensorHeading::folded(*azimuth),
        .extendedAzimuth = *azimuth,
        .revolutions = *revolutions,
        .elevation = *elevation,
        .sensorTime = *time,
        .arrival = arrival,
        .transport = Transport::Mqtt,
        .unknown = unknownOf(*object, {"dateTime", "ts", "azimuth", "elevation", "revolutions", "units"})};
}

Parsed<SensorState> parseStatus(const QByteArray& payload)
{
    return objectOf(payload).and_then([](const QJsonObject& object) -> Parsed<SensorState> {
        SensorState state{.temperature = std::nullopt,
                          .version = printable(object[QLatin1String("version")].toString().toStdString()),
                          .bssid = printable(object[QLatin1String("bssid")].toString().toStdString()),
                          .unknown = unknownOf(object, {"dateTime", "ts", "version", "bssid", "temperatureC"})};
        if (object.contains(QLatin1String("temperatureC"))) {
            const auto temperature =
                numberOf(object, QLatin1String("temperatureC"), "temperature").and_then(&temperatureOf);
            if (!temperature) {
                return tl::unexpected(temperature.error());
            }
            state.temperature = *temperature;
        }
        return state;
    });
}

Parsed<Calibration> parseCalibration(const QByteArray& payload)
{
    return objectOf(payload).and_then([](const QJsonObject& object) -> Parsed<Calibration> {
        const auto system = digitOf(object, QLatin1String("system"));
        const auto gyro = digitOf(object, QLatin1String("gyro"));
        const auto accelerometer = digitOf(object, QLatin1String("accelerometer"));
        const auto magnetometer = digitOf(object, QLatin1String("magnetometer"));
        for (const auto* const digit : {&system, &gyro, &accelerometer, &magnetometer}) {
            if (!*digit) {
                return tl::unexpected(digit->error());
            }
        }
        return Calibration{
            .system = *system, .gyro = *gyro, .accelerometer = *accelerometer, .magnetometer = *magnetometer};
    });
}

Parsed<std::optional<Orientation>> PayloadReader::take(Topic topic, const QByteArray& payload, SteadyTime arrival)
{
    auto result = read(topic, payload, arrival);
    if (result) {
        ++m_counts.accepted;
    } else {
        m_counts.count(result.error().reason);
    }
    return result;
}

Parsed<std::optional<Orientation>> PayloadReader::read(Topic topic, const QByteArray& payload, SteadyTime arrival)
{
    const auto nothing = [](const auto&) { return std::optional<Orientation>(); };
    switch (topic) {
        case Topic::Calibration:
            return parseCalibration(payload)
                .map([&](const Calibration& value) {
                    m_calibration = {value, arrival};
                })
                .map([] { return std::optional<Orientation>(); });
        case Topic::Status: {
            const auto state = parseStatus(payload);
            if (state) {
                m_state = ReportedState{.value = *state, .arrival = arrival};
                m_firmware = state->version;
            }
            return state.map(nothing);
        }
        case Topic::Orientation:
            break;
    }
    return parseOrientation(payload, arrival).map([this](Orientation value) {
        return std::optional<Orientation>(joined(std::move(value)));
    });
}

Orientation PayloadReader::joined(Orientation orientation) const
{
    if (m_calibration && orientation.arrival - m_calibration->arrival <= kCalibrationKept) {
        orientation.calibration = m_calibration->value;
    }
    if (m_state && orientation.arrival - m_state->arrival <= kStatusKept) {
        orientation.temperature = m_state->value.temperature;
    }
    return orientation;
}

}  // namespace boresight::orientation

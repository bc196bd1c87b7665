// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the firmware of the sensor: the sentence on its serial port, and the JSON of its three MQTT topics.
#include "core/base/numbers.h"
#include "core/orientation/sentence.h"
#include "core/sim/simulated_sensor.h"

#include <QDateTime>
#include <QLocale>

namespace boresight::sim {
namespace {

std::int64_t milliseconds(UtcTime time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

// The firmware prints these runs of spaces.
QString head(const SensorMessage& message)
{
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(milliseconds(message.time), Qt::UTC);
    const QString text = QLocale::c().toString(time, QStringLiteral("dddd, dd-MMM-yyyy HH:mm:ss 'UTC'"));
    return QStringLiteral("{  \"dateTime\": \"%1\",  \"ts\": \"%2\",  ").arg(text).arg(milliseconds(message.time));
}

}  // namespace

std::string toSentence(const SensorMessage& message)
{
    const orientation::Calibration& calibration = message.calibration;
    const auto number = [](std::int64_t value) { return std::to_string(value) + ","; };
    return orientation::withChecksum("PATRK," + number(milliseconds(message.time)) + "ms," +
                                     formatFixed(message.azimuth, 2) + ",dd," + formatFixed(message.elevation, 2) +
                                     ",dd," + number(message.revolutions) + "revs," + number(message.temperature) +
                                     "c," + number(calibration.system) + number(calibration.gyro) +
                                     number(calibration.accelerometer) + std::to_string(calibration.magnetometer)) +
           "\r\n";
}

QByteArray toPayload(const SensorMessage& message, orientation::Topic topic)
{
    const orientation::Calibration& calibration = message.calibration;
    QString text = head(message);
    switch (topic) {
        case orientation::Topic::Orientation:
            text += QStringLiteral(
                        "\"azimuth\": %1,  \"elevation\": %2,  \"revolutions\": %3,  \"units\": {    \"ts\": "
                        "\"milliseconds\",    \"orientation\": \"decimal degrees\"  }}")
                        .arg(message.azimuth, 0, 'f', 2)
                        .arg(message.elevation, 0, 'f', 2)
                        .arg(message.revolutions);
            break;
        case orientation::Topic::Status:
            text += QStringLiteral("\"version\": \"2.0.6b\",  \"bssid\": \"02:00:00:00:00:01\",  \"temperatureC\": %1}")
                        .arg(message.temperature);
            break;
        case orientation::Topic::Calibration:
            text += QStringLiteral("\"system\": %1,  \"gyro\": %2,  \"accelerometer\": %3,  \"magnetometer\": %4}")
                        .arg(calibration.system)
                        .arg(calibration.gyro)
                        .arg(calibration.accelerometer)
                        .arg(calibration.magnetometer);
            break;
    }
    return text.toUtf8();
}

}  // namespace boresight::sim

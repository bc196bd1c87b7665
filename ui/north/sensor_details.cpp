// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/sensor_details.h"

#include "ui/kit/format.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace boresight::ui {

namespace {

using orientation::Refusal;

QString reasonText(Refusal reason)
{
    switch (reason) {
        case Refusal::WrongChecksum:
            return SensorDetails::tr("wrong checksum");
        case Refusal::NoChecksum:
            return SensorDetails::tr("no checksum");
        case Refusal::BadChecksum:
            return SensorDetails::tr("checksum that is not a number");
        case Refusal::Truncated:
            return SensorDetails::tr("cut off");
        case Refusal::TooLong:
            return SensorDetails::tr("too long");
        case Refusal::FieldCount:
            return SensorDetails::tr("wrong number of fields");
        case Refusal::Unit:
            return SensorDetails::tr("unknown unit");
        case Refusal::NotANumber:
            return SensorDetails::tr("not a number");
        case Refusal::NotFinite:
            return SensorDetails::tr("not a finite number");
        case Refusal::OutOfRange:
            return SensorDetails::tr("number out of range");
        case Refusal::Retained:
            return SensorDetails::tr("stored by the broker");
        case Refusal::NotJson:
            return SensorDetails::tr("not JSON");
    }
    return {};
}

QString numberText(std::uint64_t number)
{
    return QString::number(number);
}

// Late values show their age.
QString aged(const QString& value, std::chrono::milliseconds age, std::chrono::milliseconds late)
{
    return age < late ? value : SensorDetails::tr("%1 (%2 ago)").arg(value, waitText(age));
}

// The names and values of unknown members. Unreadable data is one line.
std::vector<std::pair<QString, QString>> membersOf(const std::string& json)
{
    std::vector<std::pair<QString, QString>> members;
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    for (auto member = object.begin(); member != object.end(); ++member) {
        members.emplace_back(member.key(), member.value().toVariant().toString());
    }
    if (members.empty() && !json.empty()) {
        members.emplace_back(SensorDetails::tr("more"), QString::fromStdString(json));
    }
    return members;
}

constexpr std::chrono::seconds kValueLate{3};
constexpr std::chrono::seconds kFirmwareLate{90};  // the firmware sends one each minute

}  // namespace

SensorDetails::SensorDetails(QObject* parent) : TableModel({tr("Reported"), tr("Value")}, parent) {}

void SensorDetails::addReadings(const SensorStatus& sensor, Lines& lines)
{
    if (!sensor.last || !sensor.age) {
        lines.emplace_back(tr("last value"), tr("none"));
        return;
    }
    const orientation::Orientation& last = *sensor.last;
    const auto add = [&](const QString& what, const QString& value) {
        lines.emplace_back(what, aged(value, *sensor.age, kValueLate));
    };
    add(tr("azimuth as sent"), angleText(last.extendedAzimuth));
    add(tr("elevation"), angleText(last.elevation));
    add(tr("revolutions as sent"), QString::number(last.revolutions));
    lines.emplace_back(tr("revolutions counted here"), QString::number(sensor.turns));
    add(tr("time of the sensor"), dateText(last.sensorTime));
    add(tr("temperature"), last.temperature ? tr("%1 °C").arg(*last.temperature, 0, 'f', 0) : tr("not reported"));
    if (!last.unknown.empty()) {
        add(tr("unknown part"), QString::fromStdString(last.unknown));
    }
}

void SensorDetails::addFirmware(const SensorStatus& sensor, Lines& lines)
{
    if (!sensor.firmware || !sensor.firmwareAge) {
        lines.emplace_back(tr("status of the firmware"), tr("not reported"));
        return;
    }
    const auto add = [&](const QString& what, const QString& value) {
        lines.emplace_back(what,
                           aged(value.isEmpty() ? tr("not reported") : value, *sensor.firmwareAge, kFirmwareLate));
    };
    add(tr("firmware"), QString::fromStdString(sensor.firmware->version));
    add(tr("WiFi access point"), QString::fromStdString(sensor.firmware->bssid));
    for (const auto& [name, value] : membersOf(sensor.firmware->unknown)) {
        add(name, value);
    }
}

void SensorDetails::addCounts(const SensorStatus& sensor, Lines& lines)
{
    lines.emplace_back(tr("messages used"), numberText(sensor.counts.accepted));
    lines.emplace_back(tr("messages refused"), numberText(sensor.counts.allRefused()));
    for (std::size_t i = 0; i < orientation::kRefusals; ++i) {
        const auto reason = static_cast<Refusal>(i);
        if (const std::uint64_t count = sensor.counts.of(reason); count > 0) {
            lines.emplace_back(tr("refused: %1").arg(reasonText(reason)), numberText(count));
        }
    }
    lines.emplace_back(tr("lines of others"), numberText(sensor.counts.foreign + sensor.counts.chatter));
    lines.emplace_back(tr("jumps left out"), numberText(sensor.outliers));
    lines.emplace_back(tr("restarts of the sensor"), numberText(sensor.restarts));
}

void SensorDetails::show(const SensorStatus& sensor)
{
    Lines lines;
    if (sensor.configured()) {
        lines.emplace_back(tr("source"), sensor.source);
        addReadings(sensor, lines);
        addFirmware(sensor, lines);
        addCounts(sensor, lines);
    } else {
        lines.emplace_back(tr("source"), tr("no sensor is set"));
    }
    if (lines.size() == m_lines.size()) {
        m_lines = std::move(lines);
        changeCells();
        return;
    }
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

QString SensorDetails::text() const
{
    QStringList all;
    for (const auto& [what, value] : m_lines) {
        all << what + QLatin1Char('\t') + value;
    }
    return all.join(QLatin1Char('\n'));
}

QVariant SensorDetails::data(const QModelIndex& index, int role) const
{
    const auto& [what, value] = m_lines.at(static_cast<std::size_t>(index.row()));
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) {
        return index.column() == 0 && role == Qt::DisplayRole ? what : value;
    }
    return {};
}

}  // namespace boresight::ui

#include "moc_sensor_details.cpp"

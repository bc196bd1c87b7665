// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnostics/report.h"

#include "core/base/version.h"

#include <QDateTime>
#include <QStringList>
#include <QSysInfo>

#include <archive.h>

#include <utility>

namespace boresight::diagnostics {

namespace {

QString angleText(const std::optional<Angle>& angle)
{
    return angle ? QString::number(angle->degrees(), 'f', 3) + QStringLiteral("°") : QStringLiteral("unknown");
}

QString numberText(const std::optional<double>& value, const char* unit)
{
    return value ? QString::number(*value, 'f', 2) + QLatin1Char(' ') + QString::fromUtf8(unit)
                 : QStringLiteral("unknown");
}

// Unknown values for a mount without moteus drives.
DrivesStatus drivesOf(const StationStatus& status)
{
    return status.drives.value_or(DrivesStatus());
}

QString orUnknown(const QString& text)
{
    return text.isEmpty() ? QStringLiteral("unknown") : text;
}

QString driveVersion(const char* axis, const DriveStatus& drive)
{
    if (!drive.present) {
        return QStringLiteral("%1 drive: none").arg(QLatin1String(axis));
    }
    return QStringLiteral("%1 drive: id %2, firmware %3, register map %4, UUID %5")
        .arg(QLatin1String(axis))
        .arg(drive.id)
        .arg(orUnknown(drive.identity.firmware))
        .arg(drive.identity.registerMap)
        .arg(orUnknown(drive.identity.uuid));
}

QString verdictText(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Unread:
            return QStringLiteral("unread");
        case Verdict::Right:
            return QStringLiteral("OK");
        case Verdict::Advised:
            return QStringLiteral("ADVISED");
        case Verdict::Dangerous:
            return QStringLiteral("UNSAFE");
    }
    return {};
}

QStringList driveLines(const char* axis, const DriveStatus& drive, bool turnKnown)
{
    if (!drive.present) {
        return {driveVersion(axis, drive), QString()};
    }
    QStringList lines{driveVersion(axis, drive),
                      turnKnown ? QStringLiteral("cable wrap: known") : QStringLiteral("cable wrap: unknown")};
    lines << (drive.crashStop ? QStringLiteral("crash-stop test %1: stopped from %2°/s after %3° and %4 ms (drive %5)")
                                    .arg(utcText(drive.crashStop->when))
                                    .arg(drive.crashStop->rate.degrees(), 0, 'f', 2)
                                    .arg(drive.crashStop->angle.degrees(), 0, 'f', 2)
                                    .arg(drive.crashStop->time.count())
                                    .arg(drive.crashStop->drive)
                              : QStringLiteral("crash-stop test: not run"));
    for (const ProtectionLine& line : drive.protections) {
        lines << QStringLiteral("%1  %2  found %3  wanted %4")
                     .arg(verdictText(line.verdict), line.key, orUnknown(line.found), line.wanted);
    }
    lines << QString();
    return lines;
}

QString axisLine(const char* name, const AxisStatus& axis, const DriveStatus& drive)
{
    return QStringLiteral(
               "%1: %2, actual %3, commanded %4, target %5, age %6, supply %7, board %8, motor %9, "
               "%10 %11")
        .arg(QLatin1String(name), word(axis.state), angleText(axis.actual), angleText(axis.commanded),
             angleText(axis.target),
             axis.age ? QStringLiteral("%1 ms").arg(axis.age->count()) : QStringLiteral("unknown"),
             numberText(axis.busVoltage, "V"), numberText(axis.boardTemperature, "°C"),
             numberText(axis.motorTemperature, "°C"))
        .arg(drive.registers, axis.stateText);
}

QStringList startsLine(const char* name, const AxisStatus& axis)
{
    if (!axis.starts) {
        return {};
    }
    return {QStringLiteral("%1 motor: %2 starts in the last minute, %3 since the mount was connected, coasts %4")
                .arg(QLatin1String(name))
                .arg(axis.starts->lastMinute)
                .arg(axis.starts->total)
                .arg(angleText(axis.starts->coast))};
}

QString joined(const QStringList& lines)
{
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace

QString utcText(UtcTime time)
{
    const auto sinceEpoch = std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch());
    return QDateTime::fromSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODate);
}

QString versionsText(const StationStatus& status)
{
    const DrivesStatus drives = drivesOf(status);
    return joined(
        {QStringLiteral("Boresight %1").arg(QString::fromUtf8(kVersion.data(), int(kVersion.size()))),
         QStringLiteral("Qt %1, built with %2").arg(QLatin1String(qVersion()), QStringLiteral(QT_VERSION_STR)),
         QLatin1String(archive_version_string()), QStringLiteral("system: %1").arg(QSysInfo::prettyProductName()),
         QStringLiteral("kernel: %1 %2").arg(QSysInfo::kernelType(), QSysInfo::kernelVersion()),
         QStringLiteral("processor: %1").arg(QSysInfo::currentCpuArchitecture()),
         driveVersion("azimuth", drives.azimuth), driveVersion("elevation", drives.elevation)});
}

QString drivesText(const StationStatus& status)
{
    if (!status.drives) {
        return joined({QStringLiteral("the mount has no drives that can be read")});
    }
    const DrivesStatus& drives = *status.drives;
    QStringList lines{QStringLiteral("drive check: %1")
                          .arg(drives.driveCheck == DriveCheckState::Done
                                   ? QStringLiteral("done")
                                   : QStringLiteral("not done %1").arg(drives.driveCheckText))};
    if (!drives.armingObstacle.isEmpty()) {
        lines << QStringLiteral("nothing may move: %1").arg(drives.armingObstacle);
    }
    for (const UnknownBoard& board : drives.unknownBoards) {
        lines << QStringLiteral("not in the profile: id %1, firmware %2, UUID %3")
                     .arg(board.id)
                     .arg(orUnknown(board.identity.firmware), orUnknown(board.identity.uuid));
    }
    lines << QString() << driveLines("azimuth", drives.azimuth, status.azimuth.turnKnown)
          << driveLines("elevation", drives.elevation, status.elevation.turnKnown);
    return joined(lines);
}

QString stationText(const StationStatus& status)
{
    const DrivesStatus drives = drivesOf(status);
    QStringList lines{QStringLiteral("UTC %1").arg(utcText(status.utc)),
                      QStringLiteral("state %1 (%2)%3")
                          .arg(word(status.state), status.stateReason,
                               status.stopLatched ? QStringLiteral(", STOP is latched") : QString()),
                      QStringLiteral("target: %1 by %2").arg(orUnknown(status.targetText), status.commander.name),
                      QStringLiteral("bus: %1%2")
                          .arg(status.line.name, status.simulated ? QStringLiteral(" (simulated)") : QString()),
                      QStringLiteral("delay of the control ticks: median %1 ms, p99 %2 ms, largest %3 ms. %4")
                          .arg(status.timing.lateP50.count() * 1e3, 0, 'f', 1)
                          .arg(status.timing.lateP99.count() * 1e3, 0, 'f', 1)
                          .arg(status.timing.lateWorst.count() * 1e3, 0, 'f', 1)
                          .arg(status.timing.scheduling),
                      QStringLiteral("rotctld: listens on %1").arg(orUnknown(status.listening)),
                      axisLine("azimuth", status.azimuth, drives.azimuth),
                      axisLine("elevation", status.elevation, drives.elevation)};
    if (!status.line.condition.isEmpty()) {
        lines << status.line.condition;
    }
    lines << startsLine("azimuth", status.azimuth) << startsLine("elevation", status.elevation);
    if (status.broker.wanted) {
        lines << QStringLiteral("mqtt: %1%2%3")
                     .arg(status.broker.name,
                          status.broker.connected ? QStringLiteral(" connected ") : QStringLiteral(" "),
                          status.broker.problem);
    }
    for (const std::string& key : status.waitingKeys) {
        lines << QStringLiteral("waits for a reconnect: %1").arg(QString::fromStdString(key));
    }
    for (const ClientStatus& client : status.clients) {
        lines << QStringLiteral("client %1 %2, %3 commands/s, last: %4%5")
                     .arg(client.address, client.program)
                     .arg(client.commandsPerSecond, 0, 'f', 1)
                     .arg(client.lastCommand, client.inControl ? QStringLiteral(", leads") : QString());
    }
    for (const Alarm& alarm : status.alarms) {
        QStringList sentences{alarm.what, alarm.action, alarm.remedy};
        sentences.removeAll(QString());
        lines << QStringLiteral("alarm since %1%2: %3")
                     .arg(utcText(alarm.since), alarm.active ? QString() : QStringLiteral(", over"),
                          sentences.join(QLatin1Char(' ')));
    }
    return joined(lines);
}

}  // namespace boresight::diagnostics

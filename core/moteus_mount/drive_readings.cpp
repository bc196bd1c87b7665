// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_readings.h"

#include "core/base/text.h"
#include "core/moteus/faults.h"

namespace boresight {
namespace {

QString numbered(std::string_view words, int number)
{
    return QStringLiteral("%1 (%2)").arg(Text::of(words), QString::number(number));
}

// In every mode but "fault" the number names the active limit.
QString faultWords(const DriveReport& report)
{
    if (report.fault == 0) {
        return Text::tr("none");
    }
    const QString words = numbered(moteus::faultText(report.fault).name, report.fault);
    return report.mode == moteus::Mode::Fault ? words : Text::tr("limit: %1").arg(words);
}

}  // namespace

DriveReadings readingsOf(const Drive& drive, SteadyTime now)
{
    DriveReadings readings{.sent = drive.replyCount().sent, .answered = drive.replyCount().answered};
    const auto& report = drive.report();
    if (!report) {
        return readings;
    }
    readings.motorTurns = report->position ? std::optional(report->position->turns()) : std::nullopt;
    readings.motorTurnsPerSecond = report->rate ? std::optional(report->rate->turns()) : std::nullopt;
    readings.torque = report->torque;
    readings.qCurrent = report->current;
    readings.dCurrent = report->dCurrent;
    readings.busVoltage = report->voltage;
    readings.boardTemperature = report->boardTemperature;
    readings.motorTemperature = report->motorTemperature;
    readings.power = report->power;
    readings.mode = numbered(moteus::modeText(report->mode), static_cast<int>(report->mode));
    readings.fault = faultWords(*report);
    readings.age = std::chrono::duration_cast<std::chrono::milliseconds>(now - report->received);
    return readings;
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_alarms.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/moteus/faults.h"
#include "core/supervision/finding_words.h"
#include "core/units/degrees_text.h"
#include "core/units/duration_text.h"

#include <QStringList>

namespace boresight::drive_alarms {
namespace {

using supervision::Symptom;
using supervision::Weight;

// The texts of a fault are sentences without a full stop.
QString causeAndRemedy(const moteus::FaultText& text)
{
    return text.cause.empty() ? Text::of(text.remedy)
                              : Text::tr("Likely cause: %1. %2").arg(Text::of(text.cause), Text::of(text.remedy));
}

// Codes of the limits by heat (register 0x00f).
constexpr int kBoardWarm = 100;
constexpr int kMotorWarm = 101;

// Both sentences without a full stop. Empty if the temperature is not reported.
QString cooling(const QString& changed, const QString& same, const std::optional<double>& then,
                const std::optional<double>& now)
{
    if (!now) {
        return {};
    }
    const QString after = supervision::words(*now, 0);
    const QString before = supervision::words(then.value_or(*now), 0);
    return before == after ? same.arg(after) : changed.arg(before, after);
}

// Fault 38 does not say whether the board or the motor was too hot.
QString heatText(const Heat& then, const Heat& now)
{
    QStringList sentences{cooling(Text::tr("The board was at %1 °C and is at %2 °C now"),
                                  Text::tr("The board is at %1 °C"), then.board, now.board),
                          cooling(Text::tr("The motor was at %1 °C and is at %2 °C now"),
                                  Text::tr("The motor is at %1 °C"), then.motor, now.motor)};
    sentences.removeAll(QString());
    return sentences.join(QStringLiteral(". "));
}

// `heat` is added to the remedy. Empty: nothing is added.
AlarmCase fault(const QString& drive, int code, const QString& heat = {})
{
    if (code == 0) {
        return {alarmEntry("drive.fault-unnamed"), {drive}};
    }
    const moteus::FaultText text = moteus::faultText(code);
    const QString help = causeAndRemedy(text);
    const QString remedy = heat.isEmpty() ? help : QStringLiteral("%1. %2").arg(help, heat);
    return {alarmEntry("drive.fault"),
            {drive, QString::number(code), Text::of(text.meaning),
             text.saysRearm ? remedy : Text::tr("%1. Then press Re-arm").arg(remedy)}};
}

QString remedyOfLoss(const QString& advice)
{
    return advice.isEmpty() ? Text::tr("Check the supply, the CAN cable and the adapter. Then press Re-arm")
                            : Text::tr("%1 Then press Re-arm").arg(advice);
}

QString remedyOfSilence(const QString& advice, bool needsRearm, const QString& withoutAdvice)
{
    return advice.isEmpty() ? withoutAdvice : needsRearm ? Text::tr("%1 Then press Re-arm").arg(advice) : advice;
}

QString nothingMoves()
{
    return Text::tr("Nothing moves before a re-arm");
}

// Smaller movements would show as 0.0°.
bool isWorthAWord(Angle moved)
{
    return abs(moved) >= Angle::fromDegrees(0.05);
}

// The alarm that stops the mount, for symptoms that can grow from a warning to a stop.
const AlarmEntry& stopEntryOf(Symptom symptom)
{
    switch (symptom) {
        case Symptom::FollowingError:
            return alarmEntry("axis.following-error.stop");
        case Symptom::MovesUncommanded:
            return alarmEntry("axis.moves-uncommanded.stop");
        case Symptom::EncoderJump:
            return alarmEntry("axis.encoder-jump.stop");
        case Symptom::OutsideTravel:
            return alarmEntry("axis.outside-travel.stop");
        case Symptom::SupplyLow:
            return alarmEntry("axis.supply-low.stop");
        case Symptom::Stalled:
        case Symptom::WrongWay:
        case Symptom::RepliesLate:
        case Symptom::SupplyHigh:
        case Symptom::BoardHot:
        case Symptom::MotorHot:
        case Symptom::TorqueHigh:
        case Symptom::TorqueGuard:
            break;
    }
    return entryOf(symptom);
}

}  // namespace

AlarmCase silenced(const QString& drive, Seconds watchdog, const QString& advice)
{
    return {alarmEntry("drive.silent"), {drive, QString::number(watchdog.count()), remedyOfLoss(advice)}};
}

AlarmCase unheard(const QString& drive, const QString& advice, bool needsRearm)
{
    return {alarmEntry("drive.no-reply"),
            {drive, remedyOfSilence(advice, needsRearm,
                                    Text::tr("Check the supply, the CAN cable, the adapter and the id of the drive. "
                                             "The page Drives lists the drives"))}};
}

AlarmCase answersAgain(const QString& drive, Seconds silent, const std::optional<Angle>& moved)
{
    const QString how = !moved ? nothingMoves()
                        : !isWorthAWord(*moved)
                            ? Text::tr("The axis did not move while no reply came. Its position is still known")
                            : Text::tr("The axis moved %1 while no reply came. Its position is still known")
                                  .arg(degreesText(abs(*moved)));
    return {alarmEntry("drive.answers-again"), {drive, durationText(silent), how}};
}

AlarmCase bothSilenced(Seconds watchdog, const QString& advice)
{
    return {alarmEntry("drives.silent"), {QString::number(watchdog.count()), remedyOfLoss(advice)}};
}

AlarmCase noneHeard(const QString& advice, bool needsRearm)
{
    return {alarmEntry("drives.no-reply"),
            {remedyOfSilence(advice, needsRearm,
                             Text::tr("Check the supply, the CAN cable, the adapter and the ids of the drives. The "
                                      "page Drives lists the drives"))}};
}

AlarmCase bothAnswerAgain(Seconds silent, const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation)
{
    const auto how = [&] {
        if (!azimuth || !elevation) {
            return nothingMoves();
        }
        if (!isWorthAWord(*azimuth) && !isWorthAWord(*elevation)) {
            return Text::tr("The mount did not move while no reply came. Its position is still known");
        }
        return Text::tr("Azimuth moved %1 and elevation %2 while no reply came. The position is still known")
            .arg(degreesText(abs(*azimuth)), degreesText(abs(*elevation)));
    };
    return {alarmEntry("drives.answer-again"), {durationText(silent), how()}};
}

AlarmCase timedOutByStall(const QString& drive, Seconds stalled)
{
    constexpr Seconds kWhole{10.0};  // a shorter stall has decimals
    return {alarmEntry("drive.timed-out-by-stall"),
            {drive, stalled < kWhole ? QStringLiteral("%1 s").arg(stalled.count(), 0, 'f', 2) : durationText(stalled)}};
}

AlarmCase lost(const QString& drive, DriveLoss loss, int faultCode)
{
    switch (loss) {
        case DriveLoss::Fault:
            return fault(drive, faultCode);
        case DriveLoss::TimedOut:
            return {alarmEntry("drive.timed-out"), {drive}};
        case DriveLoss::Released:
            return {alarmEntry("drive.switched-off"), {drive}};
        case DriveLoss::Blind:
            return {alarmEntry("drive.no-position"), {drive}};
        case DriveLoss::Disobeys:
            return {alarmEntry("drive.disobeys"), {drive}};
        case DriveLoss::Silent:
            break;
    }
    return unheard(drive, {}, true);
}

AlarmCase tooHot(const QString& drive, int faultCode, const Heat& then, const Heat& now)
{
    return fault(drive, faultCode, heatText(then, now));
}

AlarmCase activeLimit(const QString& drive, int code, const Heat& now)
{
    const moteus::FaultText limit = moteus::faultText(code);
    if (code == kBoardWarm && now.board) {
        return {alarmEntry("drive.limit-board-warm"),
                {drive, supervision::words(*now.board, 0), causeAndRemedy(limit)}};
    }
    if (code == kMotorWarm && now.motor) {
        return {alarmEntry("drive.limit-motor-warm"),
                {drive, supervision::words(*now.motor, 0), causeAndRemedy(limit)}};
    }
    return {alarmEntry("drive.limit"), {drive, QString::number(code), Text::of(limit.meaning), causeAndRemedy(limit)}};
}

QString limitClause(int code)
{
    return Text::tr(" (limit %1 of the drive: %2)")
        .arg(QString::number(code), Text::of(moteus::faultText(code).meaning));
}

AlarmCase supervised(const supervision::Observed& observed)
{
    const bool stopped = observed.weight == Weight::Stop;
    return {stopped ? stopEntryOf(observed.symptom) : entryOf(observed.symptom), {observed.what}};
}

const AlarmEntry& entryOf(Symptom symptom)
{
    switch (symptom) {
        case Symptom::FollowingError:
            return alarmEntry("axis.following-error");
        case Symptom::Stalled:
            return alarmEntry("axis.stalled");
        case Symptom::WrongWay:
            return alarmEntry("axis.wrong-way");
        case Symptom::MovesUncommanded:
            return alarmEntry("axis.moves-uncommanded");
        case Symptom::EncoderJump:
            return alarmEntry("axis.encoder-jump");
        case Symptom::OutsideTravel:
            return alarmEntry("axis.outside-travel");
        case Symptom::RepliesLate:
            return alarmEntry("axis.replies-late");
        case Symptom::SupplyLow:
            return alarmEntry("axis.supply-low");
        case Symptom::SupplyHigh:
            return alarmEntry("axis.supply-high");
        case Symptom::BoardHot:
            return alarmEntry("axis.board-hot");
        case Symptom::MotorHot:
            return alarmEntry("axis.motor-hot");
        case Symptom::TorqueHigh:
            return alarmEntry("axis.torque-high");
        case Symptom::TorqueGuard:
            break;
    }
    return alarmEntry("axis.torque-guard");
}

AlarmCase unordered(const QString& drive, moteus::Mode mode)
{
    return {alarmEntry("drive.active-unordered"), {drive, Text::of(moteus::modeText(mode))}};
}

}  // namespace boresight::drive_alarms

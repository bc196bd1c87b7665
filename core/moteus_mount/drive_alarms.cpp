// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_alarms.h"

#include "core/base/text.h"
#include "core/moteus/faults.h"

namespace boresight::drive_alarms {
namespace {

AlarmText silenced(const QString& drive, Seconds watchdog)
{
    return {.what = Text::tr("No reply from the %1").arg(drive),
            .action = Text::tr("Motion ended; the drive, if it has power, stops itself by its watchdog (%1 s)")
                          .arg(watchdog.count()),
            .remedy = Text::tr("Check the supply, the CAN cable and the adapter, then re-arm"),
            .symptom = true};
}

QString meaning(const moteus::FaultText& text)
{
    return text.cause.empty() ? Text::of(text.meaning)
                              : Text::tr("%1. Likely: %2").arg(Text::of(text.meaning), Text::of(text.cause));
}

AlarmText fault(const QString& drive, int code)
{
    if (code == 0) {
        return {.what = Text::tr("%1 is in fault and does not say which").arg(drive),
                .action = Text::tr("The drive switched its output off; the other axis holds if its drive can"),
                .remedy = Text::tr("Look at it with boresightctl scan; then re-arm"),
                .brief = Text::tr("in fault, does not say which")};
    }
    const moteus::FaultText text = moteus::faultText(code);
    return {.what = Text::tr("%1 fault %2: %3").arg(drive, QString::number(code), meaning(text)),
            .action = Text::tr("The drive switched its output off; the other axis holds if its drive can"),
            .remedy = text.saysRearm ? Text::of(text.remedy) : Text::tr("%1, then re-arm").arg(Text::of(text.remedy)),
            .brief = Text::tr("fault %1: %2").arg(QString::number(code), meaning(text))};
}

}  // namespace

AlarmText silent(const QString& drive)
{
    return {.what = Text::tr("No reply from the %1").arg(drive),
            .action = Text::tr("Nothing is commanded"),
            .remedy = Text::tr("Check the supply, the CAN cable, the adapter and the drive's id in the profile; "
                               "boresightctl scan tells who answers"),
            .symptom = true};
}

AlarmText answersAgain(const QString& drive)
{
    return {.what = Text::tr("The %1 fell silent; it answers again").arg(drive),
            .action = Text::tr("Motion ended; nothing moves before a re-arm"),
            .remedy = Text::tr("Look for a loose plug, a worn cable or a weak supply, then re-arm"),
            .symptom = true};
}

AlarmText lost(const QString& drive, DriveLoss loss, int faultCode, Seconds watchdog)
{
    switch (loss) {
        case DriveLoss::Silent:
            return silenced(drive, watchdog);
        case DriveLoss::Fault:
            return fault(drive, faultCode);
        case DriveLoss::TimedOut:
            return {.what = Text::tr("The %1 timed out: it got no command in time").arg(drive),
                    .action = Text::tr("It stopped itself by its watchdog; the motion of both axes ended"),
                    .remedy = Text::tr("Check the bus and the load of this computer, then re-arm")};
        case DriveLoss::Released:
            return {
                .what = Text::tr("The %1 switched itself off").arg(drive),
                .action = Text::tr("Motion ended; an order under way may have switched it on again, then it holds by "
                                   "itself; the other axis holds if its drive can"),
                .remedy = Text::tr("Its supply failed or another program stopped it: check both, then re-arm")};
        case DriveLoss::Blind:
            return {.what = Text::tr("The %1 does not report a position that can be believed").arg(drive),
                    .action = Text::tr("It was ordered to brake and hold; the motion of both axes ended"),
                    .remedy = Text::tr("Check its encoder and the CAN cable, then re-arm")};
        case DriveLoss::Disobeys:
            break;
    }
    return {.what = Text::tr("The %1 answers but does not do what it is told").arg(drive),
            .action = Text::tr("Nothing is commanded any more; the other axis holds if its drive can"),
            .remedy = Text::tr("Look at its mode and fault; another program may command it; then re-arm")};
}

AlarmText activeLimit(const QString& drive, int code)
{
    const moteus::FaultText limit = moteus::faultText(code);
    return {.what = Text::tr("%1 limit %2: %3").arg(drive, QString::number(code), meaning(limit)),
            .action = Text::tr("The drive gives less than it was asked for"),
            .remedy = Text::of(limit.remedy),
            .brief = QStringLiteral("%1: %2").arg(QString::number(code), meaning(limit))};
}

AlarmText supervised(const supervision::Observed& observed)
{
    const bool stopped = observed.weight == supervision::Weight::Stop;
    const bool addsRearm = stopped && !supervision::saysRearm(observed.finding);
    return {
        .what = observed.what,
        .action = stopped ? Text::tr("Both axes came to rest and hold where they are") : Text::tr("The mount goes on"),
        .remedy = addsRearm ? Text::tr("%1 Then re-arm").arg(observed.remedy) : observed.remedy};
}

AlarmText unordered(const QString& drive, moteus::Mode mode)
{
    return {.what = Text::tr("%1 is active without our orders: mode %2").arg(drive, Text::of(moteus::modeText(mode))),
            .action = Text::tr("Boresight does not touch it before a command; STOP takes it over and holds"),
            .remedy = Text::tr("Another program, or an order left without a watchdog, drives it: end that")};
}

}  // namespace boresight::drive_alarms

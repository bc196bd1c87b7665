// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/drive_alarms.h"

#include "core/moteus/faults.h"

namespace boresight::drive_alarms {
namespace {

AlarmText silenced(const QString& drive, Seconds watchdog)
{
    return {.what = QStringLiteral("No reply from the %1").arg(drive),
            .action = QStringLiteral("Motion ended; the drive, if it has power, stops itself by its watchdog (%1 s)")
                          .arg(watchdog.count()),
            .remedy = QStringLiteral("Check the supply, the CAN cable and the adapter, then re-arm"),
            .symptom = true};
}

QString likely(const moteus::FaultText& text)
{
    return text.cause.empty() ? QString() : QStringLiteral(". Likely: ") + toQString(text.cause);
}

// Once: some remedies say themselves when.
QString thenRearm(QString remedy)
{
    if (remedy.contains(QLatin1String("re-arm"))) {
        return remedy;
    }
    return remedy +
           (remedy.endsWith(QLatin1Char('.')) ? QStringLiteral(" Then re-arm") : QStringLiteral(", then re-arm"));
}

AlarmText fault(const QString& drive, int code)
{
    if (code == 0) {
        return {.what = QStringLiteral("%1 is in fault and does not say which").arg(drive),
                .action = QStringLiteral("The drive switched its output off; the other axis holds if its drive can"),
                .remedy = QStringLiteral("Look at it with boresightctl scan; then re-arm")};
    }
    const moteus::FaultText text = moteus::faultText(code);
    return {.what = QStringLiteral("%1 fault %2: %3").arg(drive).arg(code).arg(toQString(text.meaning)) + likely(text),
            .action = QStringLiteral("The drive switched its output off; the other axis holds if its drive can"),
            .remedy = thenRearm(toQString(text.remedy))};
}

}  // namespace

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

AlarmText silent(const QString& drive)
{
    return {.what = QStringLiteral("No reply from the %1").arg(drive),
            .action = QStringLiteral("Nothing is commanded"),
            .remedy = QStringLiteral("Check the supply, the CAN cable, the adapter and the drive's id in the profile; "
                                     "boresightctl scan tells who answers"),
            .symptom = true};
}

AlarmText answersAgain(const QString& drive)
{
    return {.what = QStringLiteral("The %1 fell silent; it answers again").arg(drive),
            .action = QStringLiteral("Motion ended; nothing moves before a re-arm"),
            .remedy = QStringLiteral("Look for a loose plug, a worn cable or a weak supply, then re-arm"),
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
            return {.what = QStringLiteral("The %1 timed out: it got no command in time").arg(drive),
                    .action = QStringLiteral("It stopped itself by its watchdog; the motion of both axes ended"),
                    .remedy = QStringLiteral("Check the bus and the load of this computer, then re-arm")};
        case DriveLoss::Released:
            return {
                .what = QStringLiteral("The %1 switched itself off").arg(drive),
                .action = QStringLiteral("Motion ended; the other axis holds if its drive can"),
                .remedy = QStringLiteral("Its supply failed or another program stopped it: check both, then re-arm")};
        case DriveLoss::Disobeys:
            break;
    }
    return {.what = QStringLiteral("The %1 answers but does not do what it is told").arg(drive),
            .action = QStringLiteral("Nothing is commanded any more; the other axis holds if its drive can"),
            .remedy = QStringLiteral("Look at its mode and fault; another program may command it; then re-arm")};
}

AlarmText activeLimit(const QString& drive, int code)
{
    const moteus::FaultText limit = moteus::faultText(code);
    return {
        .what = QStringLiteral("%1 limit %2: %3").arg(drive).arg(code).arg(toQString(limit.meaning)) + likely(limit),
        .action = QStringLiteral("The drive gives less than it was asked for"),
        .remedy = toQString(limit.remedy)};
}

AlarmText supervised(const supervision::Observed& observed)
{
    const bool stopped = observed.weight == supervision::Weight::Stop;
    return {.what = observed.what,
            .action = stopped ? QStringLiteral("Both axes came to rest and hold where they are")
                              : QStringLiteral("The mount goes on"),
            .remedy = stopped ? thenRearm(observed.remedy) : observed.remedy};
}

AlarmText unordered(const QString& drive, moteus::Mode mode)
{
    return {
        .what =
            QStringLiteral("%1 is active without our orders: mode %2").arg(drive, toQString(moteus::modeText(mode))),
        .action = QStringLiteral("Boresight does not touch it before a command; STOP takes it over and holds"),
        .remedy = QStringLiteral("Another program, or an order left without a watchdog, drives it: end that")};
}

}  // namespace boresight::drive_alarms

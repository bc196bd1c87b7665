// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/clock_words.h"

#include "ui/kit/format.h"

#include <QCoreApplication>

#include <optional>

namespace boresight::ui {

namespace {

constexpr Seconds kSecond{1.0};
constexpr Seconds kMillisecond{1e-3};
constexpr int kAngleDecimals = 3;

struct ClockWords
{
    Q_DECLARE_TR_FUNCTIONS(ClockWords)
};

QString errorText(Seconds error)
{
    return error < 10.0 * kMillisecond ? ClockWords::tr("%1 ms").arg(error / kMillisecond, 0, 'f', 1)
           : error < kSecond           ? ClockWords::tr("%1 ms").arg(error / kMillisecond, 0, 'f', 0)
                                       : ClockWords::tr("%1 s").arg(error.count(), 0, 'f', 1);
}

QString signedSeconds(Seconds time)
{
    return (time < Seconds(0.0) ? QString() : QStringLiteral("+")) + QString::number(time.count(), 'f', 0);
}

std::optional<AngularRate> trackedRate(const StationStatus& status)
{
    return status.tracked ? status.tracked->skyRate : std::nullopt;
}

// How far the tracked target moves in this time.
QString shiftText(AngularRate rate, Seconds time)
{
    return angleText(rate * time, kAngleDecimals);
}

}  // namespace

QString utcText(const StationStatus& status)
{
    return clockText(status.utc) + (status.clock.synchronised ? QStringLiteral("Z") : QStringLiteral("Z?"));
}

QString clockErrorText(const StationStatus& status)
{
    if (status.clock.ahead) {
        return ClockWords::tr("set by %1 s").arg(signedSeconds(*status.clock.ahead));
    }
    const auto rate = trackedRate(status);
    if (!status.clock.synchronised) {
        return rate ? ClockWords::tr("1 s = %1").arg(shiftText(*rate, kSecond)) : ClockWords::tr("not set");
    }
    if (!status.clock.error) {
        return {};
    }
    const Seconds error = *status.clock.error;
    return rate ? ClockWords::tr("±%1 = %2").arg(errorText(error), shiftText(*rate, error))
                : ClockWords::tr("±%1").arg(errorText(error));
}

QString widestClockErrorText()
{
    return ClockWords::tr("±%1 = %2").arg(errorText(900.0 * kMillisecond), shiftText(1_deg_s, kSecond));
}

QString clockHelp(const StationStatus& status)
{
    if (status.clock.ahead) {
        return ClockWords::tr(
                   "The clock of the station was set by %1 s. Boresight still uses the old time, which is shown here. "
                   "To change this, press Use new time on the alarm.")
            .arg(signedSeconds(*status.clock.ahead));
    }
    const auto rate = trackedRate(status);
    if (!status.clock.synchronised) {
        const QString what = ClockWords::tr("No time source sets the clock of the station. Set up NTP or GPS.");
        return rate ? ClockWords::tr("%1 An error of one second is %2 for %3.")
                          .arg(what, shiftText(*rate, kSecond), status.tracked->name)
                    : ClockWords::tr("%1 A satellite 420 km up moves 1° in a second.").arg(what);
    }
    if (!status.clock.error) {
        return ClockWords::tr("A time source sets the clock of the station.");
    }
    const Seconds error = *status.clock.error;
    const QString text =
        ClockWords::tr("A time source sets the clock of the station. It reports an error of %1.").arg(errorText(error));
    return rate ? ClockWords::tr("%1 That is %2 for %3.").arg(text, shiftText(*rate, error), status.tracked->name)
                : text;
}

}  // namespace boresight::ui

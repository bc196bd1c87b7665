// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/clock_words.h"

#include "ui/kit/format.h"

#include <QCoreApplication>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kMillisecond = 1e-3;

struct ClockWords
{
    Q_DECLARE_TR_FUNCTIONS(ClockWords)
};

// The speed of the tracked target across the sky.
AngularRate skyRate(const StationStatus& status)
{
    const Angle elevation = status.elevation.actual.value_or(Angle{});
    const double azimuth =
        status.azimuth.commandedRate.value_or(AngularRate{}).degrees() * std::cos(elevation.radians());
    return AngularRate::fromDegrees(
        std::hypot(azimuth, status.elevation.commandedRate.value_or(AngularRate{}).degrees()));
}

}  // namespace

QString utcText(const StationStatus& status)
{
    return clockText(status.utc) + (status.clock.synchronised ? QStringLiteral("Z") : QStringLiteral("Z?"));
}

QString clockHelp(const StationStatus& status)
{
    if (!status.clock.synchronised) {
        return ClockWords::tr(
            "No time source sets the clock of the station. Satellites, Sun and Moon may be elsewhere: a "
            "satellite 420 km up moves 1° in a second. Set up NTP or GPS.");
    }
    if (!status.clock.error) {
        return ClockWords::tr("A time source sets the clock of the station.");
    }
    const QString text = ClockWords::tr("A time source sets the clock of the station. It reports an error of %1 ms.")
                             .arg(status.clock.error->count() / kMillisecond, 0, 'f', 1);
    return status.tracked ? ClockWords::tr("%1 That is %2 for %3.")
                                .arg(text, angleText(skyRate(status) * *status.clock.error, 3), status.tracked->name)
                          : text;
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_words.h"

#include "core/elements/julian_date.h"
#include "core/orbit/element_age.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/targets/target.h"
#include "core/units/angle_between.h"
#include "ui/kit/format.h"

#include <QStringList>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace boresight::ui {

namespace {

constexpr Seconds kHour{3600.0};
constexpr double kSecondsPerDay = 86'400.0;

QString momentText(const QString& words, const passes::PassMoment& moment, const QString& angle)
{
    return words.arg(clockText(moment.utc), angle);
}

// The change of direction when the satellite comes this late. Computed for the highest moment, when it moves fastest
// over the sky.
Angle shiftOf(const BookedPass& one, const PassBook& book, Seconds late)
{
    const orbit::Sgp4 orbit(book.elementsOf(one));
    const orbit::Observer observer(book.site);
    const auto directionAt = [&](UtcTime utc) -> std::optional<SkyPointing> {
        const orbit::JulianDate date = orbit::julianDate(utc);
        const auto state = orbit.propagate(date);
        return state ? std::optional(observer.look(orbit::groundState(*state, date)).direction) : std::nullopt;
    };
    const UtcTime highest = one.pass.tca.utc;
    const auto expected = directionAt(highest);
    const auto real = directionAt(highest - std::chrono::round<UtcTime::duration>(late));
    return expected && real ? angleBetween(*expected, *real) : 0_deg;
}

// When the antenna sees the satellite. A pass behind many obstacles has more parts than a line has room for.
QStringList seenText(const passes::Pass& pass)
{
    constexpr qsizetype kMostParts = 4;
    QStringList parts;
    for (const passes::Stretch& part : pass.clear) {
        if (parts.size() == kMostParts) {
            parts << QStringLiteral("…");
            break;
        }
        parts << QStringLiteral("%1–%2").arg(clockText(part.from), clockText(part.to));
    }
    return parts.isEmpty() ? QStringList()
                           : QStringList(PassWords::tr("seen %1 UTC").arg(parts.join(QStringLiteral(", "))));
}

QString beamText(Angle beam)
{
    return angleText(beam, beam < 1_deg ? 2 : 1);
}

// With two decimals, because a tenth of a degree is too coarse for a narrow beam.
QString ageText(const ElementAge& age)
{
    const QString words =
        age.isTooOld ? PassWords::tr("elements %1 days old: expected error %2 s or %3, more than half the beam of %4")
                     : PassWords::tr("elements %1 days old: expected error %2 s or %3, beam %4");
    return words.arg(age.days).arg(age.late.count(), 0, 'f', 1).arg(angleText(age.shift, 2), beamText(age.beam));
}

QString briefAgeText(const ElementAge& age)
{
    const QString words = age.isTooOld ? PassWords::tr("elements %1 d old: error %2 s, %3, beam %4, too old")
                                       : PassWords::tr("elements %1 d old: error %2 s, %3, beam %4");
    return words.arg(age.days).arg(age.late.count(), 0, 'f', 1).arg(angleText(age.shift, 2), beamText(age.beam));
}

}  // namespace

ElementAge ageOf(const BookedPass& one, const PassBook& book, UtcTime now)
{
    const orbit::ElementSet& elements = book.elementsOf(one);
    const double days = Seconds(now - orbit::utcTime(elements.epoch)).count() / kSecondsPerDay;
    const orbit::AgeError error = orbit::expectedError(elements, one.pass.tca.utc);
    const Angle shift = shiftOf(one, book, error.time);
    return {.days = QString::number(std::max(0.0, days), 'f', 1),
            .late = error.time,
            .shift = shift,
            .beam = book.antennaOf(one).beamWidth,
            .isTooOld = 2.0 * shift > book.antennaOf(one).beamWidth};
}

QString lengthText(Seconds time)
{
    const auto whole = std::llround(time.count());
    const QLatin1Char zero('0');
    return time < kHour ? QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, zero)
                        : QStringLiteral("%1 h %2").arg(whole / 3600).arg(whole / 60 % 60, 2, 10, zero);
}

QString riseText(const passes::Pass& pass)
{
    return pass.isUpAtStart ? PassWords::tr("up") : clockText(pass.aos.utc);
}

QString setText(const passes::Pass& pass)
{
    return pass.isUpAtEnd ? PassWords::tr("up") : clockText(pass.los.utc);
}

QString partText(Seconds part, Seconds whole)
{
    constexpr Seconds kNothing{1.0};
    if (part < kNothing) {
        return PassWords::tr("no");
    }
    return whole - part < kNothing ? PassWords::tr("all") : lengthText(part);
}

QString untilText(const passes::Pass& pass, UtcTime now)
{
    return pass.aos.utc <= now ? PassWords::tr("up") : waitText(pass.aos.utc - now);
}

Seconds hiddenTime(const passes::Pass& pass)
{
    return std::max(Seconds(0.0), pass.duration() - pass.clearTime());
}

QString daysText(const ElementAge& age)
{
    return (age.isTooOld ? PassWords::tr("%1 d, too old") : PassWords::tr("%1 d")).arg(age.days);
}

QString factsOf(const BookedPass& one, const PassBook& book, UtcTime now)
{
    const orbit::ElementSet& elements = book.elementsOf(one);
    const passes::Pass& pass = one.pass;
    QStringList lines{PassWords::tr("%1, number %2").arg(targets::satelliteName(elements)).arg(elements.number)};
    if (!pass.isUpAtStart) {
        lines << momentText(PassWords::tr("rises %1Z at %2"), pass.aos, azimuthText(pass.aos.direction.azimuth, 0));
    }
    lines << momentText(PassWords::tr("highest %1Z, %2 up"), pass.tca, angleText(pass.tca.direction.elevation, 0));
    if (!pass.isUpAtEnd) {
        lines << momentText(PassWords::tr("sets %1Z at %2"), pass.los, azimuthText(pass.los.direction.azimuth, 0));
    }
    if (const Seconds hidden = hiddenTime(pass); hidden >= Seconds(1.0)) {
        lines << PassWords::tr("hidden for %1 by the limits").arg(lengthText(hidden));
        lines << seenText(pass);
    }
    lines << ageText(ageOf(one, book, now));
    return lines.join(QLatin1Char('\n'));
}

QString briefFactsOf(const BookedPass& one, const PassBook& book, UtcTime now, bool isNamed)
{
    const passes::Pass& pass = one.pass;
    const orbit::ElementSet& elements = book.elementsOf(one);
    const QString words = isNamed ? PassWords::tr("%1, from %2 to %3") : PassWords::tr("number %1, from %2 to %3");
    const QString which = isNamed ? targets::satelliteName(elements) : QString::number(elements.number);
    QStringList first{
        words.arg(which, azimuthText(pass.aos.direction.azimuth, 0), azimuthText(pass.los.direction.azimuth, 0))};
    // Beside a name there is no room for this text, so it has its own line. Beside a number it is shorter.
    if (const Seconds hidden = hiddenTime(pass); hidden >= Seconds(1.0)) {
        first << (isNamed ? PassWords::tr("hidden for %1 by the limits") : PassWords::tr("hidden for %1"))
                     .arg(lengthText(hidden));
    }
    return first.join(isNamed ? QStringLiteral("\n") : QStringLiteral(", ")) + QLatin1Char('\n') +
           briefAgeText(ageOf(one, book, now));
}

// A pass of many hours may have more than two changes. The first two are shown.
QString lightText(const passes::PassLight& light)
{
    const auto time = [&](std::size_t number) { return clockText(light.changes.at(number)); };
    switch (std::min<std::size_t>(light.changes.size(), 2)) {
        case 0:
            return light.isSunlitFirst ? PassWords::tr("in sunlight") : PassWords::tr("in the shadow of the Earth");
        case 1:
            return (light.isSunlitFirst ? PassWords::tr("enters the shadow %1Z")
                                        : PassWords::tr("leaves the shadow %1Z"))
                .arg(time(0));
        default:
            return (light.isSunlitFirst ? PassWords::tr("in the shadow %1Z to %2Z")
                                        : PassWords::tr("in sunlight %1Z to %2Z"))
                .arg(time(0), time(1));
    }
}

QString briefCableText(const targets::CableTurns& cable)
{
    if (cable.turns == 0) {
        return PassWords::tr("no");
    }
    return cable.fitsOverTheTop ? PassWords::tr("over the top") : lengthText(cable.lost);
}

QString cableFact(const targets::CableTurns& cable)
{
    return cable.fitsOverTheTop ? PassWords::tr("goes over the top, because the cable ends. Nothing is lost")
                                : PassWords::tr("unwraps the cable, which loses %1").arg(lengthText(cable.lost));
}

QString cableText(const targets::CableTurns& cable)
{
    if (cable.hasRoom) {
        return PassWords::tr("The cable has room for all of the pass.");
    }
    if (cable.hasGap) {
        return PassWords::tr("The azimuth turns less than 360°, so the mount does not track all of the pass.");
    }
    const QString turns = cable.turns == 1 ? PassWords::tr("The cable ends during the pass.")
                                           : PassWords::tr("The cable ends %1 times during the pass.").arg(cable.turns);
    const QString way =
        cable.fitsOverTheTop
            ? PassWords::tr("Boresight tracks the pass over the top, with elevations above 90°, and loses nothing.")
            : PassWords::tr("Boresight unwraps it by 360° there and loses %1 of the pass.").arg(lengthText(cable.lost));
    return turns + QLatin1Char(' ') + way;
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/goto_answer.h"

#include "core/base/numbers.h"
#include "core/pointing/pointing_model.h"
#include "core/units/direction_text.h"

#include <QRegularExpression>

#include <optional>

namespace boresight::ctl {
namespace {

constexpr Angle kNamedStep = Angle::fromDegrees(0.1);  // the station names a direction with one decimal

struct NamedPlace
{
    SkyPointing direction;
    QString reason;  // why the mount goes there instead of the target; may be empty
};

// core/clients/target_reading puts the direction in front: "30.0° / 90.0°: elevation 95.0° above limit 90.0°". Empty:
// the outcome names no other direction.
std::optional<NamedPlace> placeNamedIn(const QString& outcome)
{
    static const QRegularExpression form(QStringLiteral("^(-?[0-9.]+)° / (-?[0-9.]+)°(?:: (.+))?"));
    const QRegularExpressionMatch found = form.match(outcome);
    const auto azimuth = parseFinite(found.captured(1).toStdString());
    const auto elevation = parseFinite(found.captured(2).toStdString());
    if (!azimuth || !elevation) {
        return std::nullopt;
    }
    const SkyPointing direction{.azimuth = Angle::fromDegrees(*azimuth), .elevation = Angle::fromDegrees(*elevation)};
    return NamedPlace{.direction = pointing::upright(direction), .reason = found.captured(3)};
}

bool looksTheSame(const SkyPointing& one, const SkyPointing& other)
{
    return abs((one.azimuth - other.azimuth).wrapped180()) < kNamedStep &&
           abs(one.elevation - other.elevation) < kNamedStep;
}

QString asSentence(const QString& reason)
{
    const QString end = reason.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral(".");
    return reason.left(1).toUpper() + reason.mid(1) + end;
}

}  // namespace

GotoAnswer gotoAnswer(const SkyPointing& asked, const QString& outcome)
{
    const auto place = placeNamedIn(outcome);
    const QString there = place ? beamText(place->direction) : QString();
    if (!place || looksTheSame(place->direction, pointing::upright(asked))) {
        const QString same =
            place ? QStringLiteral(" The mount goes to %1, the same direction.").arg(there) : QString();
        return {.goesThere = true,
                .text = QStringLiteral("The station accepted the target azimuth %1, elevation %2.%3")
                            .arg(azimuthText(asked.azimuth, 2), degreesText(asked.elevation, 2), same)};
    }
    return {.goesThere = false,
            .text = place->reason.isEmpty()
                        ? QStringLiteral("The mount goes to %1 instead of the target.").arg(there)
                        : QStringLiteral("%1 The mount goes to %2, the nearest permitted direction.")
                              .arg(asSentence(place->reason), there)};
}

}  // namespace boresight::ctl

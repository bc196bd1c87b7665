// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/declination.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight::geomagnetism {

namespace {

// A compass is only exact to a few degrees, so a smaller difference does not matter.
constexpr Angle kMatters = Angle::fromDegrees(0.5);

QString signedDegrees(Angle angle)
{
    const QString text = toQString(formatFixed(angle.degrees(), 2)) + QStringLiteral("°");
    return angle.degrees() < 0.0 ? text : QStringLiteral("+") + text;
}

QString hereText(const Declination& declination)
{
    const QString value = signedDegrees(*declination.here);
    return declination.origin == DeclinationOrigin::Model ? Text::tr("%1 (magnetic model)").arg(value)
                                                          : Text::tr("%1 (entered)").arg(value);
}

}  // namespace

Result<Angle> declinationCorrection(const Declination& declination)
{
    if (declination.by != DeclinationBy::Boresight) {
        return 0_deg;
    }
    if (!declination.here) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("The declination of this site is not known. Enter it, or enter the site and the "
                                "file of the magnetic model."));
    }
    return *declination.here - declination.inSensor;
}

QString describe(const Declination& declination)
{
    const QString inSensor = signedDegrees(declination.inSensor);
    switch (declination.by) {
        case DeclinationBy::Sensor:
            return Text::tr("The sensor applies the declination (%1). Boresight adds nothing.").arg(inSensor);
        case DeclinationBy::Boresight: {
            const auto correction = declinationCorrection(declination);
            return correction ? Text::tr(
                                    "Boresight adds a declination of %2 and removes the sensor's %1. "
                                    "The sum is %3.")
                                    .arg(inSensor, hereText(declination), signedDegrees(*correction))
                              : Text::tr("Boresight cannot apply the declination. %1").arg(correction.error().text);
        }
        case DeclinationBy::None:
            return Text::tr("Nothing corrects the declination. The sensor adds %1 to the heading.").arg(inSensor);
    }
    return {};
}

QString doubt(const Declination& declination)
{
    if (declination.by == DeclinationBy::Boresight || !declination.here) {
        return {};
    }
    const Angle error = declination.inSensor - *declination.here;
    if (abs(error) < kMatters) {
        return {};
    }
    return Text::tr("The declination here is %1, but the sensor added %2. Its headings are off by %3.")
        .arg(hereText(declination), signedDegrees(declination.inSensor), signedDegrees(error));
}

}  // namespace boresight::geomagnetism

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/declination.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight::geomagnetism {

namespace {

// Less is lost in a compass that is exact to a few degrees.
constexpr Angle kMatters = Angle::fromDegrees(0.5);

QString signedDegrees(Angle angle)
{
    const QString text = toQString(formatFixed(angle.degrees(), 2)) + QStringLiteral("°");
    return angle.degrees() < 0.0 ? text : QStringLiteral("+") + text;
}

QString hereText(const Declination& declination)
{
    const QString value = signedDegrees(*declination.here);
    return declination.origin == DeclinationOrigin::Model ? Text::tr("%1 by the magnetic model").arg(value)
                                                          : Text::tr("%1 as typed").arg(value);
}

}  // namespace

Result<Angle> declinationCorrection(const Declination& declination)
{
    if (declination.by != DeclinationBy::Boresight) {
        return 0_deg;
    }
    if (!declination.here) {
        return failure(
            ErrorCode::NotAvailable,
            Text::tr("the declination of this place is not known: type it, or give site and magnetic model"));
    }
    return *declination.here - declination.inSensor;
}

QString describe(const Declination& declination)
{
    const QString inSensor = signedDegrees(declination.inSensor);
    switch (declination.by) {
        case DeclinationBy::Sensor:
            return Text::tr("Declination by the sensor: it has added %1, Boresight adds nothing").arg(inSensor);
        case DeclinationBy::Boresight: {
            const auto correction = declinationCorrection(declination);
            return correction ? Text::tr(
                                    "Declination by Boresight: the sensor's %1 is taken away and %2 is added, "
                                    "together %3")
                                    .arg(inSensor, hereText(declination), signedDegrees(*correction))
                              : Text::tr("Declination by Boresight: %1").arg(toQString(correction.error().text));
        }
        case DeclinationBy::None:
            return Text::tr("No declination: the heading stays as it comes, with the sensor's %1 in it").arg(inSensor);
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
    return Text::tr("the declination here is %1, the sensor has added %2: its headings are %3 off")
        .arg(hereText(declination), signedDegrees(declination.inSensor), signedDegrees(error));
}

}  // namespace boresight::geomagnetism

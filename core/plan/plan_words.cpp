// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/plan_words.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/units/degrees_text.h"
#include "core/units/duration_text.h"

namespace boresight::plan {

namespace {

QString keyholeText(const Forecast& forecast, const QString& target)
{
    const QString text =
        Text::tr("plans the pass of %1 near the zenith, where the azimuth is too slow: off by up to %2")
            .arg(target, errorText(forecast));
    return forecast.beyond < Seconds(0.5)
               ? text
               : QStringLiteral("%1. %2").arg(text, Text::tr("It is off by more than half of the beam width for %1")
                                                        .arg(durationText(forecast.beyond)));
}

}  // namespace

QString titleOf(PlanWay way)
{
    switch (way) {
        case PlanWay::Direct:
            return Text::tr("Direct");
        case PlanWay::OverTheTop:
            return Text::tr("Over the top");
        case PlanWay::ThroughTheZenith:
            return Text::tr("Through the zenith");
        case PlanWay::OtherWayRound:
            return Text::tr("Other way round");
        case PlanWay::WaitsAtTheEnd:
            return Text::tr("Waits at the cable end");
        case PlanWay::Unwraps:
            return Text::tr("Unwraps in the pass");
    }
    return {};
}

QString errorText(const Forecast& forecast)
{
    const QString error = degreesText(forecast.peak, 2);
    return forecast.peakLoss
               ? Text::tr("%1 (−%2 dB)").arg(error, QString::fromStdString(formatFixed(*forecast.peakLoss, 1)))
               : Text::tr("%1 (beyond the beam)").arg(error);
}

bool isPlain(const PlanVariant& variant)
{
    constexpr double kNoticed = 0.1;  // dB
    return variant.way == PlanWay::Direct && variant.forecast.peakLoss && *variant.forecast.peakLoss < kNoticed;
}

QString summaryText(const PlanVariant& variant)
{
    return variant.isWhole()
               ? Text::tr("%1, off by up to %2").arg(titleOf(variant.way), errorText(variant.forecast))
               : Text::tr("%1, off target for %2").arg(titleOf(variant.way), durationText(variant.forecast.beyond));
}

QString splitText(const PlanVariant& variant)
{
    if (variant.way == PlanWay::Unwraps && variant.unwrap) {
        return Text::tr("The mount unwraps from %1 to %2.")
            .arg(timeOfDayText(variant.unwrap->from), timeOfDayText(variant.unwrap->to));
    }
    return variant.way == PlanWay::WaitsAtTheEnd
               ? Text::tr("The mount waits at the end of the cable while the target is beyond it.")
               : QString();
}

QString planText(const PlanVariant& variant, const QString& target)
{
    const QString error = errorText(variant.forecast);
    switch (variant.way) {
        case PlanWay::Direct:
            return variant.ramp ? keyholeText(variant.forecast, target) : QString();
        case PlanWay::OverTheTop:
            return Text::tr("plans the pass of %1 over the top: off by up to %2").arg(target, error);
        case PlanWay::ThroughTheZenith:
            return Text::tr("plans the pass of %1 through the zenith, and changes over the top there: off by up to %2")
                .arg(target, error);
        case PlanWay::OtherWayRound:
            return Text::tr(
                       "plans the pass of %1 with the azimuth going the other way round near the zenith: off by up "
                       "to %2")
                .arg(target, error);
        case PlanWay::WaitsAtTheEnd:
        case PlanWay::Unwraps:
            return Text::tr("plans the pass of %1, for which the cable has no room. %2 The beam is off it for %3")
                .arg(target, splitText(variant), durationText(variant.forecast.beyond));
    }
    return {};
}

}  // namespace boresight::plan

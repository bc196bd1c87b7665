// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/variant_words.h"

#include "core/base/time_of_day.h"
#include "core/plan/plan_words.h"
#include "core/units/degrees_text.h"
#include "core/units/duration_text.h"
#include "ui/kit/format.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr Seconds kNoTime{0.5};

class VariantWords
{
    Q_DECLARE_TR_FUNCTIONS(VariantWords)
};

// "Direct: 5.30° (beyond the beam), 14 s off by more than 2.5°."
QString variantLine(const plan::PlanVariant& variant, Angle bound)
{
    const plan::Forecast& forecast = variant.forecast;
    const QString line = VariantWords::tr("%1: %2").arg(plan::titleOf(variant.way), plan::errorText(forecast));
    return forecast.beyond < kNoTime ? line + QLatin1Char('.')
                                     : VariantWords::tr("%1, %2 off by more than %3.")
                                           .arg(line, durationText(forecast.beyond), degreesText(bound));
}

QString hiddenSentence(const plan::PlanVariant& variant)
{
    return variant.forecast.hidden < kNoTime
               ? QString()
               : VariantWords::tr("The limits hide the satellite for %1.").arg(durationText(variant.forecast.hidden));
}

QString spanSentence(const QString& words, const plan::PlanSpan& span)
{
    return words.arg(timeOfDayText(span.from), timeOfDayText(span.to));
}

}  // namespace

QString lossText(const plan::Forecast& forecast)
{
    return forecast.peakLoss ? QStringLiteral("−%1 dB").arg(*forecast.peakLoss, 0, 'f', 1) : QStringLiteral(">12 dB");
}

QString spentText(Seconds time)
{
    const long seconds = std::lround(time.count());
    return time < kNoTime ? QString()
                          : QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString planSentence(const PlanAnswer& answer)
{
    if (!answer.obstacle.isEmpty()) {
        return answer.obstacle;
    }
    const plan::PlanVariant& best = answer.plan.best();
    QStringList sentences;
    if (plan::isPlain(best)) {
        sentences << VariantWords::tr("The mount follows the whole pass directly, off by up to %1.")
                         .arg(degreesText(best.forecast.peak, 2));
    } else {
        sentences << variantLine(best, answer.plan.bound);
        const auto direct = std::ranges::find(answer.plan.variants, plan::PlanWay::Direct, &plan::PlanVariant::way);
        if (direct != answer.plan.variants.end() && best.way != plan::PlanWay::Direct) {
            sentences << variantLine(*direct, answer.plan.bound);
        }
        sentences << plan::splitText(best);
    }
    sentences << hiddenSentence(best);
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

QString describedVariant(const plan::PlanVariant& variant, const TravelRange& azimuths)
{
    QStringList sentences{VariantWords::tr("%1.").arg(plan::summaryText(variant)),
                          VariantWords::tr("The azimuth goes from %1 to %2. The cable ends at %3 and %4.")
                              .arg(degreesText(variant.start().azimuth, 0), degreesText(variant.end().azimuth, 0),
                                   degreesText(azimuths.min, 0), degreesText(azimuths.max, 0))};
    if (variant.ramp) {
        sentences << spanSentence(VariantWords::tr("The azimuth leaves the satellite from %1 to %2."), *variant.ramp);
    }
    sentences << plan::splitText(variant) << hiddenSentence(variant);
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/cable_words.h"

#include "core/base/numbers.h"
#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/widest.h"
#include "ui/sky/cable_ring.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

namespace {

// Shown as 0° away.
constexpr Angle kAtEnd = Angle::fromDegrees(0.5);

class CableText
{
    Q_DECLARE_TR_FUNCTIONS(CableText)
};

QString travelText(const TravelRange& travel)
{
    return CableText::tr("travel %1…%2")
        .arg(QString::fromStdString(formatFixed(travel.min.degrees(), 0)), angleText(travel.max, 0));
}

QString unknownPlace()
{
    return CableText::tr("cable %1").arg(QStringLiteral("---°"));
}

QString endText(Angle left, const QString& wait)
{
    return CableText::tr("end in %1, %2").arg(angleText(left, 0), wait);
}

QString atEndText()
{
    return CableText::tr("at the end");
}

QString rangeSentence(const TravelRange& travel)
{
    return CableText::tr("Its travel is from %1 to %2.").arg(angleText(travel.min, 0), angleText(travel.max, 0));
}

}  // namespace

CableWords cableWords(const StationStatus& status)
{
    const CableState cable = cableOf(status);
    CableWords words;
    if (!cable.isThere()) {
        return words;
    }
    words.travel = travelText(cable.travel);
    words.tone = cable.actual && !cable.late ? Tone::Normal : Tone::Secondary;
    if (!cable.wrapKnown && !isTurnAwaited(status, Axis::Azimuth)) {
        words.place = unknownPlace();
        words.travel = CableText::tr("wrap unknown");
        words.isWarning = true;
        words.sentence = CableText::tr("The cable wrap is unknown.") + u' ' + rangeSentence(cable.travel);
    } else if (!cable.actual) {
        words.place = unknownPlace();
        words.sentence = CableText::tr("The position of the cable is unknown.") + u' ' + rangeSentence(cable.travel);
    } else {
        const Angle left = std::min(*cable.actual - cable.travel.min, cable.travel.max - *cable.actual);
        words.place = CableText::tr("cable %1").arg(angleText(*cable.actual, 0));
        words.sentence = CableText::tr("The azimuth cable is at %1.").arg(angleText(*cable.actual, 0)) + u' ' +
                         rangeSentence(cable.travel) + u' ' +
                         CableText::tr("The nearer end is %1 away.").arg(angleText(std::max(left, 0_deg), 0));
    }
    if (cable.actual && status.cableEnd) {
        const Angle left = abs(status.cableEnd->end - *cable.actual);
        const QString wait = waitText(status.cableEnd->in);
        const bool isThere = left < kAtEnd;
        words.isWarning = true;
        words.tone = Tone::Warning;
        words.travel = isThere ? atEndText() : endText(left, wait);
        words.sentence +=
            u' ' + (isThere ? CableText::tr("It is at the end.")
                            : CableText::tr("It ends at %1 in %2.").arg(angleText(status.cableEnd->end, 0), wait));
    }
    return words;
}

CableWords widestCableWords()
{
    const TravelRange wide{Angle::fromDegrees(-888.0), Angle::fromDegrees(888.0)};
    return {.place = CableText::tr("cable %1").arg(angleText(wide.min, 0)),
            .travel = widest(fonts::label(), {travelText(wide), endText(wide.max, waitText(Seconds(99.0))), atEndText(),
                                              CableText::tr("wrap unknown")}),
            .sentence = {}};
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_check.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::orbit {

QString elementProblem(const ElementSet& elements)
{
    if (elements.number < 0 || elements.number > kLargestNumber) {
        return Text::tr("The catalogue number %1 has more than 9 digits or is negative.").arg(elements.number);
    }
    if (!(elements.eccentricity >= 0.0 && elements.eccentricity < 1.0)) {
        return Text::tr("The eccentricity %1 is not from 0 to below 1.").arg(elements.eccentricity);
    }
    if (!(elements.revolutionsPerDay > 0.0)) {
        return Text::tr("The mean motion %1 rev/day is not above 0.").arg(elements.revolutionsPerDay);
    }
    if (!(elements.inclination >= 0_deg && elements.inclination <= 180_deg)) {
        return Text::tr("The inclination %1° is not from 0° to 180°.").arg(elements.inclination.degrees());
    }
    for (const Angle angle : {elements.ascendingNode, elements.perigee, elements.meanAnomaly}) {
        if (!(abs(angle) <= 360_deg)) {
            return Text::tr("The angle %1° is not from -360° to 360°.").arg(angle.degrees());
        }
    }
    return {};
}

QString quoted(std::string_view text)
{
    constexpr std::size_t kLongest = 40;
    QString shown = QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min(text.size(), kLongest)));
    for (QChar& character : shown) {
        character = character.isPrint() ? character : QChar(u'?');
    }
    return text.size() > kLongest ? shown + QChar(u'…') : shown;
}

}  // namespace boresight::orbit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_check.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::orbit {

namespace {

QString printableStart(std::string_view text, std::size_t longest)
{
    QString shown = QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min(text.size(), longest)));
    for (QChar& character : shown) {
        character = character.isPrint() || character.isSurrogate() ? character : QChar(u'?');
    }
    return text.size() > longest ? shown + QChar(u'…') : shown;
}

}  // namespace

QString elementProblem(const ElementSet& elements)
{
    if (elements.number < 0 || elements.number > kLargestNumber) {
        return Text::tr("The catalogue number is %1. It must be from 0 to 999999999.").arg(elements.number);
    }
    if (!(elements.eccentricity >= 0.0 && elements.eccentricity < 1.0)) {
        return Text::tr("The eccentricity is %1. It must be at least 0 and below 1.").arg(elements.eccentricity);
    }
    if (!(elements.revolutionsPerDay > 0.0)) {
        return Text::tr("The mean motion is %1 rev/day. It must be above 0.").arg(elements.revolutionsPerDay);
    }
    if (!(elements.inclination >= 0_deg && elements.inclination <= 180_deg)) {
        return Text::tr("The inclination is %1°. It must be from 0° to 180°.").arg(elements.inclination.degrees());
    }
    for (const Angle angle : {elements.ascendingNode, elements.perigee, elements.meanAnomaly}) {
        if (!(abs(angle) <= 360_deg)) {
            return Text::tr("An angle is %1°. It must be from -360° to 360°.").arg(angle.degrees());
        }
    }
    return {};
}

QString quoted(std::string_view text, std::size_t longest)
{
    return printableStart(text, longest);
}

std::string nameOf(std::string_view text)
{
    constexpr std::size_t kLongest = 60;  // a TLE has 24 columns for the name
    return printableStart(text, kLongest).toStdString();
}

char classificationOf(std::string_view text)
{
    const bool isLetter = !text.empty() && text.front() >= 'A' && text.front() <= 'Z';
    return isLetter ? text.front() : 'U';
}

}  // namespace boresight::orbit

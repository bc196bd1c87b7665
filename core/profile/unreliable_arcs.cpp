// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/unreliable_arcs.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QStringList>

namespace boresight::profile {
namespace {

constexpr qsizetype kMost = 36;  // the compass swing finds arcs in steps of 10°

std::optional<Angle> parseHeading(const QString& text)
{
    const auto degrees = parseFinite(text.trimmed().toStdString());
    return degrees && *degrees >= 0.0 && *degrees <= 360.0 ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
}

}  // namespace

std::string toText(const std::vector<UnreliableArc>& arcs)
{
    std::string text;
    for (const UnreliableArc& arc : arcs) {
        text += text.empty() ? "" : ", ";
        text += formatFixed(arc.from.degrees(), 1) + "-" + formatFixed(arc.to.degrees(), 1);
    }
    return text;
}

Result<std::vector<UnreliableArc>> parseArcs(const std::string& text)
{
    std::vector<UnreliableArc> arcs;
    const QString all = toQString(text).trimmed();
    const QStringList parts = all.isEmpty() ? QStringList() : all.split(QLatin1Char(','));
    for (const QString& part : parts) {
        const QStringList ends = part.split(QLatin1Char('-'));
        const auto from = parseHeading(ends.front());
        const auto to = parseHeading(ends.back());
        if (ends.size() != 2 || !from || !to || parts.size() > kMost) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("arcs of headings from 0 to 360° are expected, like \"40-80, 350-20\""));
        }
        arcs.push_back({.from = *from, .to = *to});
    }
    return arcs;
}

}  // namespace boresight::profile

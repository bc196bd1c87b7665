// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/wind_stow.h"

#include "core/base/text.h"

namespace boresight::sources {
namespace {

const Source& windSource()
{
    static const Source source{.kind = SourceKind::Operator, .name = QStringLiteral("wind")};
    return source;
}

}  // namespace

void WindStow::step(SteadyTime)
{
    const std::uint64_t onsets = helm().view().wind.onsets();
    if (onsets == m_onsets) {
        return;
    }
    m_onsets = onsets;
    helm().takeOver(windSource());
    if (!helm().current().is(Activity::None)) {
        park();
    }
}

// Ends the running motion first, so the mount stops even if it cannot be parked. The alarm then offers to park it.
void WindStow::park()
{
    const CurrentMotion& current = helm().current();
    if (current.moves() && !current.is(Activity::Parking)) {
        helm().end(Severity::Warning, Text::tr("ends the motion because of the wind"));
    }
    const AxisPosition place = Gates(helm().view()).park();
    const Result<> parked = helm().goTo(place, Activity::Parking, windSource(),
                                        Text::tr("park at %1 because of the wind").arg(helm().directionText(place)));
    if (!parked) {
        helm().note(Severity::Warning, Text::tr("does not park in the wind: %1").arg(parked.error().text));
    }
}

}  // namespace boresight::sources

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_paths.h"

#include "ui/kit/theme.h"

namespace boresight::ui {

void SkyPaths::setSky(const SkyProjection& sky)
{
    m_tracked.setSky(sky);
    m_chosen.setSky(sky);
    m_trackedBeam.setSky(sky);
    m_chosenBeam.setSky(sky);
}

// A plan never changes, so it is converted once.
QRegion SkyPaths::show(const StationStatus& status)
{
    const plan::SharedVariant plan = status.tracked ? status.tracked->plan : nullptr;
    if (plan != m_plan) {
        m_plan = plan;
        m_beamOfPlan = plan ? beamOf(*plan, pointing::PointingModel(termsOf(status))) : nullptr;
    }
    QRegion changed(m_tracked.show(status.tracked ? status.tracked->way : nullptr, status.utc));
    changed += m_chosen.show(m_chosenWay, status.utc);
    changed += m_trackedBeam.show(m_beamOfPlan, status.utc);
    changed += m_chosenBeam.show(m_beamOfChoice, status.utc);
    return changed;
}

void SkyPaths::paint(QPainter& painter) const
{
    m_chosen.paint(painter, currentTheme().secondary);
    m_tracked.paint(painter, currentTheme().accent);
    m_chosenBeam.paint(painter);
    m_trackedBeam.paint(painter);
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/sky/sky_beam.h"
#include "ui/sky/sky_path.h"

#include <QRegion>

// The coming paths in the sky: of the tracked target, and of the pass that is selected in a list, each with the planned
// beam beside it. Pixels of the widget.
namespace boresight::ui {

class SkyPaths
{
public:
    void setSky(const SkyProjection& sky);
    // Null: no pass is selected. Drawn with the next status, which has the time.
    void setChosenWay(const targets::SkyWay& way) { m_chosenWay = way; }
    void setChosenBeam(const PlannedBeam& beam) { m_beamOfChoice = beam; }
    QRegion show(const StationStatus& status);  // what is to be painted again

    void paint(QPainter& painter) const;

    [[nodiscard]] const SkyPath& tracked() const { return m_tracked; }
    [[nodiscard]] const SkyPath& chosen() const { return m_chosen; }
    [[nodiscard]] const SkyBeam& trackedBeam() const { return m_trackedBeam; }
    [[nodiscard]] const SkyBeam& chosenBeam() const { return m_chosenBeam; }
    [[nodiscard]] bool hasBeam() const { return !m_trackedBeam.line().isEmpty() || !m_chosenBeam.line().isEmpty(); }

private:
    SkyPath m_tracked;
    SkyPath m_chosen;
    SkyBeam m_trackedBeam;
    SkyBeam m_chosenBeam;
    targets::SkyWay m_chosenWay;
    PlannedBeam m_beamOfChoice;
    plan::SharedVariant m_plan;  // of the tracked target
    PlannedBeam m_beamOfPlan;    // of this plan
};

}  // namespace boresight::ui

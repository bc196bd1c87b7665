// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/sky_frame.h"

class QPainter;

namespace boresight::ui {

// What is in the sky only at times.
struct LegendParts
{
    bool hasSensor = false;
    bool hasBeam = false;  // a planned beam beside the path of the target

    bool operator==(const LegendParts&) const = default;
};

// The meaning of the markers, in the lower left corner of the plot, in as few lines as the corner beside the disc
// allows.
void paintLegend(QPainter& painter, const QRectF& view, const SkyFrame& frame, const LegendParts& parts);
[[nodiscard]] double legendHeight(const SkyFrame& frame, const LegendParts& parts);

}  // namespace boresight::ui

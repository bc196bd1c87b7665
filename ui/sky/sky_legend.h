// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/sky_frame.h"

class QPainter;

namespace boresight::ui {

// What the markers mean, in the lower left corner of the plot: as few lines as the corner beside the disc has room for.
void paintLegend(QPainter& painter, const QRectF& view, const SkyFrame& frame, bool hasSensor);
[[nodiscard]] double legendHeight(const SkyFrame& frame, bool hasSensor);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/sky_frame.h"

class QPainter;

namespace boresight::ui {

// The meaning of the markers, in the lower left corner of the plot, in as few lines as the corner beside the disc
// allows.
void paintLegend(QPainter& painter, const QRectF& view, const SkyFrame& frame, bool hasSensor);
[[nodiscard]] double legendHeight(const SkyFrame& frame, bool hasSensor);

}  // namespace boresight::ui

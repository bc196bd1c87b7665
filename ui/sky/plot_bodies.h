// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/sky/sky_projection.h"

#include <QRectF>

class QPainter;

// The Sun and the Moon on the plot: a disc with rays and a crescent, each with its name. Pixels are the widget's own.
namespace boresight::ui {

// The bodies above the horizon. A body that moves by less than a pixel keeps its place, so nothing is repainted.
[[nodiscard]] std::vector<BodyPlace> bodiesInTheSky(const std::vector<BodyPlace>& shown,
                                                    const std::vector<BodyPlace>& now);
[[nodiscard]] QRectF bodyBox(const BodyPlace& body, const SkyProjection& sky);  // symbol and name
void paintBody(QPainter& painter, const BodyPlace& body, const SkyProjection& sky);

}  // namespace boresight::ui

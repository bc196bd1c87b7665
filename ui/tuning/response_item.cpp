// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/response_item.h"

#include <QPainter>
#include <qwt_scale_map.h>

namespace boresight::ui {

void ResponseItem::draw(QPainter* painter, const QwtScaleMap& timeMap, const QwtScaleMap& valueMap,
                        const QRectF& /*canvas*/) const
{
    QPolygonF line;
    line.reserve(m_points.size());
    for (const QPointF& one : m_points) {
        line << QPointF(timeMap.transform(one.x()), valueMap.transform(one.y()));
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(m_pen);
    painter->drawPolyline(line);
    painter->restore();
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/response_item.h"

#include <QPainter>
#include <qwt_scale_map.h>

namespace boresight::ui {

void ResponseItem::draw(QPainter* painter, const QwtScaleMap& timeMap, const QwtScaleMap& valueMap,
                        const QRectF& /*canvas*/) const
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(m_pen);
    for (const QPolygonF& piece : m_pieces) {
        QPolygonF line;
        line.reserve(piece.size());
        for (const QPointF& one : piece) {
            line << QPointF(timeMap.transform(one.x()), valueMap.transform(one.y()));
        }
        painter->drawPolyline(line);
    }
    painter->restore();
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/sky_moment.h"
#include "ui/sky/sky_projection.h"

#include <QColor>
#include <QPainterPath>
#include <QRect>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

// The coming path of a satellite or a body across the sky. The line is dotted where the limits of the mount hide it. It
// has a dot at each whole minute, or each hour of a long path, and the times of its beginning and end. Pixels of the
// widget.
namespace boresight::ui {

class SkyPath
{
public:
    // An end of the way.
    struct End
    {
        QPointF pixel;
        QRectF text;  // beside it, inside the sky
        QString time;
        bool isBegin = false;
    };

    // The rectangle to be painted again. Empty if nothing has changed.
    QRect show(const targets::SkyWay& way, UtcTime utc);
    void setSky(const SkyProjection& sky);

    void paint(QPainter& painter, const QColor& colour) const;

    [[nodiscard]] const QPainterPath& clear() const { return m_clear; }
    [[nodiscard]] const QPainterPath& hidden() const { return m_hidden; }
    [[nodiscard]] const std::vector<QPointF>& dots() const { return m_dots; }
    [[nodiscard]] const std::vector<End>& ends() const { return m_ends; }

private:
    void rebuild();
    void addLines();
    void addDots();
    void addEnd(const targets::SkyMoment& moment, bool isBegin);
    [[nodiscard]] QRectF boxBeside(const QPointF& end, const QSizeF& size) const;
    [[nodiscard]] QRect box() const;

    SkyProjection m_sky;
    targets::SkyWay m_way;
    std::size_t m_first = 0;  // index of the first moment that is still to come
    QPainterPath m_clear;
    QPainterPath m_hidden;
    std::vector<QPointF> m_dots;
    std::vector<End> m_ends;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_beam.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kBeamLine = 2.0;  // px

}  // namespace

void SkyBeam::setSky(const SkyProjection& sky)
{
    m_sky = sky;
    rebuild();
}

QRect SkyBeam::show(const PlannedBeam& beam, UtcTime utc)
{
    std::size_t first = 0;
    if (beam) {
        first = static_cast<std::size_t>(std::ranges::upper_bound(*beam, utc, {}, &BeamMoment::utc) - beam->begin());
    }
    if (beam == m_beam && first == m_first) {
        return {};
    }
    const QRect before = box();
    m_beam = beam;
    m_first = first;
    rebuild();
    return before | box();
}

void SkyBeam::rebuild()
{
    m_line.clear();
    for (std::size_t i = m_first; m_beam && i + 1 < m_beam->size(); ++i) {
        const BeamMoment& from = (*m_beam)[i];
        if (!from.isApart) {
            continue;
        }
        const QPointF begin = m_sky.toPixel(from.direction);
        if (m_line.isEmpty() || m_line.currentPosition() != begin) {
            m_line.moveTo(begin);
        }
        m_line.lineTo(m_sky.toPixel((*m_beam)[i + 1].direction));
    }
}

QRect SkyBeam::box() const
{
    return m_line.isEmpty() ? QRect() : m_line.boundingRect().toAlignedRect().adjusted(-3, -3, 3, 3);
}

QPen SkyBeam::pen()
{
    QPen pen(currentTheme().accent, kBeamLine, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({2.0, 1.5});
    return pen;
}

void SkyBeam::paint(QPainter& painter) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen());
    painter.drawPath(m_line);
}

}  // namespace boresight::ui

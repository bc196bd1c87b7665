// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/setting_picture.h"

#include "core/profile/setting.h"
#include "ui/kit/theme.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <string_view>

namespace boresight::ui {

namespace {

using Kind = SettingPicture::Kind;

constexpr double kWide = 48.0;  // the pictures are drawn in a box of this size
constexpr double kHigh = 32.0;
constexpr QSize kViewSize{96, 64};
constexpr QPointF kMiddle(kWide / 2.0, kHigh / 2.0);
constexpr double kGround = 27.0;

struct Match
{
    std::string_view part;  // a part of the key
    Kind kind;
};

// The first match counts.
constexpr Match kMatches[] = {{"mount.geometry", Kind::Geometry},
                              {"mount.x_axis", Kind::Geometry},
                              {".travel_m", Kind::Travel},
                              {"limits.azimuth_", Kind::AzimuthLimits},
                              {"limits.elevation_", Kind::ElevationLimits},
                              {profile::kHorizonKey, Kind::Horizon},
                              {profile::kKeepOutKey, Kind::KeepOut},
                              {".sign", Kind::Direction},
                              {"mount.directions", Kind::Direction},
                              {"sensor.azimuth_sense", Kind::Direction},
                              {".gear_", Kind::Gear},
                              {"park.", Kind::Park},
                              {".max_speed", Kind::Speed},
                              {"jog.", Kind::Speed},
                              {".max_acceleration", Kind::Acceleration},
                              {".max_jerk", Kind::Acceleration},
                              {"beam_width", Kind::Beam},
                              {"pointing.azimuth_offset", Kind::North},
                              {"sensor.azimuth_offset", Kind::North},
                              {"pointing.tilt", Kind::Tilt},
                              {"pointing.elevation_sag", Kind::Tilt},
                              {"sun.", Kind::Sun}};

QPen line(double width = 1.2)
{
    return {currentTheme().secondary, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

QPen strong(double width = 2.2)
{
    return {currentTheme().accent, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void circle(QPainter& painter, const QPointF& middle, double radius)
{
    painter.drawEllipse(middle, radius, radius);
}

// Angles in degrees, counterclockwise from the right.
void arc(QPainter& painter, const QPointF& middle, double radius, double from, double span)
{
    const QRectF box(middle - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
    painter.drawArc(box, static_cast<int>(from * 16), static_cast<int>(span * 16));
}

QPointF around(const QPointF& middle, double radius, double degrees)
{
    return QLineF::fromPolar(radius, degrees).translated(middle).p2();
}

void dot(QPainter& painter, const QPointF& at, const QColor& colour, double radius = 2.6)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    circle(painter, at, radius);
    painter.setBrush(Qt::NoBrush);
}

void arrowHead(QPainter& painter, const QPointF& tip, double degrees)
{
    painter.drawPolyline(QPolygonF({around(tip, 4.5, degrees + 150.0), tip, around(tip, 4.5, degrees - 150.0)}));
}

void ground(QPainter& painter)
{
    painter.setPen(line());
    painter.drawLine(QPointF(4, kGround), QPointF(kWide - 4, kGround));
}

// A dish on its mast that points to the right, this many degrees above the ground.
void dish(QPainter& painter, double degrees, const QPen& pen)
{
    painter.setPen(pen);
    const QPointF hub(16, 18);
    painter.drawLine(hub, QPointF(16, kGround));
    arc(painter, around(hub, 6, degrees), 7, degrees + 110.0, 140.0);
    painter.drawLine(hub, around(hub, 8, degrees));
}

class PictureIcon : public QIconEngine
{
public:
    explicit PictureIcon(const SettingPicture& picture) : m_picture(picture) {}

    // In a selected row the picture has the colour of its text.
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        if (mode != QIcon::Selected) {
            m_picture.draw(*painter, rect);
            return;
        }
        const qreal density = painter->device()->devicePixelRatioF();
        QPixmap drawn(rect.size() * density);
        drawn.setDevicePixelRatio(density);
        drawn.fill(Qt::transparent);
        QPainter one(&drawn);
        const QRect box(QPoint(), rect.size());
        m_picture.draw(one, box);
        one.setCompositionMode(QPainter::CompositionMode_SourceIn);
        one.fillRect(box, currentTheme().plotGround);
        one.end();
        painter->drawPixmap(rect.topLeft(), drawn);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new PictureIcon(*this); }

private:
    SettingPicture m_picture;
};

}  // namespace

SettingPicture::SettingPicture(const std::string& key)
{
    const auto* const found =
        std::ranges::find_if(kMatches, [&key](const Match& one) { return key.find(one.part) != std::string::npos; });
    m_kind = found == std::end(kMatches) ? Kind::None : found->kind;
    m_isUpper = key.find("_max_deg") != std::string::npos || key.find("elevation_deg") != std::string::npos;
}

void SettingPicture::draw(QPainter& painter, const QRectF& box) const
{
    using Draw = void (SettingPicture::*)(QPainter&) const;
    static constexpr Draw kDraws[] = {nullptr,
                                      &SettingPicture::drawGeometry,
                                      &SettingPicture::drawTravel,
                                      &SettingPicture::drawAzimuthLimits,
                                      &SettingPicture::drawElevationLimits,
                                      &SettingPicture::drawHorizon,
                                      &SettingPicture::drawKeepOut,
                                      &SettingPicture::drawDirection,
                                      &SettingPicture::drawGear,
                                      &SettingPicture::drawPark,
                                      &SettingPicture::drawSpeed,
                                      &SettingPicture::drawAcceleration,
                                      &SettingPicture::drawBeam,
                                      &SettingPicture::drawNorth,
                                      &SettingPicture::drawTilt,
                                      &SettingPicture::drawSun};
    if (m_kind == Kind::None) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(box.width() / kWide, box.height() / kHigh);
    painter.translate(box.center() - scale * kMiddle);
    painter.scale(scale, scale);
    (this->*kDraws[static_cast<std::size_t>(m_kind)])(painter);
    painter.restore();
}

QIcon SettingPicture::icon() const
{
    return QIcon(new PictureIcon(*this));
}

// The lower axis lies level on two posts. The dish leans beside it.
void SettingPicture::drawGeometry(QPainter& painter) const
{
    ground(painter);
    for (const double post : {12.0, 36.0}) {
        painter.drawLine(QPointF(post, kGround), QPointF(post, 19));
    }
    painter.setPen(strong());
    painter.drawLine(QPointF(8, 19), QPointF(40, 19));
    arc(painter, QPointF(24, 19), 10, 40, 100);
    arrowHead(painter, around(QPointF(24, 19), 10, 40), -50);
    painter.setPen(line(1.8));
    painter.drawLine(QPointF(24, 19), QPointF(24, 12));
    arc(painter, QPointF(24, 5), 7, 200, 140);
}

// One and a half turns, wound outwards: the cable, with the end that the setting moves.
void SettingPicture::drawTravel(QPainter& painter) const
{
    QPainterPath spiral;
    constexpr int kFrom = 90;
    constexpr int kTo = -450;
    for (int degrees = kFrom; degrees >= kTo; degrees -= 10) {
        const QPointF point = around(kMiddle, 6.0 + 8.0 * (kFrom - degrees) / (kFrom - kTo), degrees);
        degrees == kFrom ? spiral.moveTo(point) : spiral.lineTo(point);
    }
    painter.setPen(line(1.6));
    painter.drawPath(spiral);
    dot(painter, m_isUpper ? spiral.currentPosition() : around(kMiddle, 6.0, kFrom), currentTheme().accent, 3.2);
}

void SettingPicture::drawAzimuthLimits(QPainter& painter) const
{
    painter.setPen(line());
    circle(painter, kMiddle, 13);
    painter.setPen(strong(1.4));
    painter.setBrush(currentTheme().accentSoft);
    painter.drawPie(QRectF(kMiddle - QPointF(13, 13), QSizeF(26, 26)), -30 * 16, 240 * 16);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(strong(2.8));
    painter.drawLine(kMiddle, around(kMiddle, 13, m_isUpper ? -30 : 210));
}

void SettingPicture::drawElevationLimits(QPainter& painter) const
{
    ground(painter);
    const QPointF corner(10, kGround);
    painter.setPen(line());
    painter.setBrush(currentTheme().accentSoft);
    painter.drawPie(QRectF(corner - QPointF(22, 22), QSizeF(44, 44)), 12 * 16, 60 * 16);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(strong());
    painter.drawLine(corner, around(corner, 24, m_isUpper ? 72 : 12));
}

void SettingPicture::drawHorizon(QPainter& painter) const
{
    painter.setPen(strong(1.8));
    painter.setBrush(currentTheme().band);
    painter.drawPolygon(QPolygonF({QPointF(3, 29), QPointF(3, 22), QPointF(11, 17), QPointF(18, 22), QPointF(27, 11),
                                   QPointF(36, 19), QPointF(45, 15), QPointF(45, 29)}));
}

void SettingPicture::drawKeepOut(QPainter& painter) const
{
    painter.setPen(line());
    circle(painter, kMiddle, 14);
    circle(painter, kMiddle, 5);
    QPainterPath sector;
    sector.arcMoveTo(QRectF(kMiddle - QPointF(13, 13), QSizeF(26, 26)), 20);
    sector.arcTo(QRectF(kMiddle - QPointF(13, 13), QSizeF(26, 26)), 20, 60);
    sector.arcTo(QRectF(kMiddle - QPointF(6, 6), QSizeF(12, 12)), 80, -60);
    sector.closeSubpath();
    painter.setPen(strong(1.4));
    painter.setBrush(QBrush(currentTheme().accent, Qt::BDiagPattern));
    painter.drawPath(sector);
    painter.setBrush(Qt::NoBrush);
}

void SettingPicture::drawDirection(QPainter& painter) const
{
    painter.setPen(line());
    circle(painter, kMiddle, 6);
    painter.setPen(strong());
    arc(painter, kMiddle, 12, 60, 240);
    arrowHead(painter, around(kMiddle, 12, 60), -30);
    painter.setPen(line());
    arc(painter, kMiddle, 12, -45, 90);
}

void SettingPicture::drawGear(QPainter& painter) const
{
    painter.setPen(line(3.0));
    for (int degrees = 0; degrees < 360; degrees += 30) {
        painter.drawLine(around(QPointF(30, 16), 10, degrees), around(QPointF(30, 16), 12.5, degrees));
    }
    painter.setPen(line());
    circle(painter, QPointF(30, 16), 10);
    circle(painter, QPointF(30, 16), 2);
    painter.setPen(strong(2.0));
    circle(painter, QPointF(11, 16), 5.5);
    dot(painter, QPointF(11, 16), currentTheme().accent, 1.5);
}

void SettingPicture::drawPark(QPainter& painter) const
{
    ground(painter);
    dish(painter, 25, line());
    dish(painter, 80, strong(1.8));
    painter.setPen(strong(1.8));
    painter.drawRoundedRect(QRectF(32, 6, 12, 14), 2.5, 2.5);
    painter.drawLine(QPointF(36, 17), QPointF(36, 9));
    arc(painter, QPointF(37.5, 11.2), 2.4, -90, 180);
}

void SettingPicture::drawSpeed(QPainter& painter) const
{
    const QPointF hub(kWide / 2.0, 24);
    painter.setPen(line());
    arc(painter, hub, 16, 0, 180);
    for (int degrees = 0; degrees <= 180; degrees += 45) {
        painter.drawLine(around(hub, 13, degrees), around(hub, 16, degrees));
    }
    painter.setPen(strong());
    painter.drawLine(hub, around(hub, 12, 30));
    dot(painter, hub, currentTheme().accent);
}

// The speed over time: it rises, stays constant, falls.
void SettingPicture::drawAcceleration(QPainter& painter) const
{
    painter.setPen(line());
    painter.drawPolyline(QPolygonF({QPointF(5, 5), QPointF(5, kGround), QPointF(kWide - 3, kGround)}));
    painter.drawLine(QPointF(18, 10), QPointF(30, 10));
    painter.setPen(strong());
    painter.drawLine(QPointF(6, 26), QPointF(18, 10));
    painter.drawLine(QPointF(30, 10), QPointF(42, 26));
}

void SettingPicture::drawBeam(QPainter& painter) const
{
    ground(painter);
    dish(painter, 40, line());
    const QPointF from(20, 15);
    painter.setPen(strong(1.6));
    painter.setBrush(currentTheme().accentSoft);
    painter.drawPolygon(QPolygonF({from, around(from, 26, 32), around(from, 26, 52)}));
    painter.setBrush(Qt::NoBrush);
}

void SettingPicture::drawNorth(QPainter& painter) const
{
    painter.setPen(line());
    circle(painter, kMiddle, 13);
    painter.drawLine(kMiddle, around(kMiddle, 13, 90));
    painter.drawLine(QPointF(24, 0.5), QPointF(24, 4));
    painter.setPen(strong());
    painter.drawLine(kMiddle, around(kMiddle, 12, 50));
    arrowHead(painter, around(kMiddle, 12, 50), 50);
    painter.setPen(strong(1.2));
    arc(painter, kMiddle, 7, 50, 40);
}

void SettingPicture::drawTilt(QPainter& painter) const
{
    ground(painter);
    painter.setPen(QPen(currentTheme().secondary, 1.2, Qt::DashLine));
    painter.drawLine(QPointF(24, kGround), QPointF(24, 3));
    painter.setPen(strong());
    painter.drawLine(QPointF(24, kGround), around(QPointF(24, kGround), 24, 74));
    painter.setPen(strong(1.2));
    arc(painter, QPointF(24, kGround), 16, 74, 16);
}

void SettingPicture::drawSun(QPainter& painter) const
{
    painter.setPen(QPen(currentTheme().accent, 1.6, Qt::DashLine));
    circle(painter, QPointF(32, 14), 11);
    dot(painter, QPointF(32, 14), currentTheme().warning, 4.5);
    ground(painter);
    dish(painter, 75, line());
}

SettingPictureView::SettingPictureView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    hide();
}

void SettingPictureView::setKey(const std::string& key)
{
    m_key = key;
    setVisible(SettingPicture(key).kind() != SettingPicture::Kind::None);
    update();
}

QSize SettingPictureView::sizeHint() const
{
    return kViewSize;
}

void SettingPictureView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    SettingPicture(m_key).draw(painter, rect());
}

}  // namespace boresight::ui

#include "moc_setting_picture.cpp"

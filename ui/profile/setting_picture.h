// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QWidget>

#include <string>

class QPainter;

// Small pictures of the effect of a setting, one function for each kind. They are drawn in the colours of the current
// theme, with the part that the setting changes in the accent colour.
namespace boresight::ui {

class SettingPicture
{
public:
    enum class Kind
    {
        None,
        Geometry,
        Travel,  // of an axis, as a cable
        AzimuthLimits,
        ElevationLimits,
        Horizon,
        KeepOut,
        Direction,
        Gear,
        Park,
        Speed,
        Acceleration,
        Beam,
        North,
        Tilt,
        Sun
    };

    explicit SettingPicture(const std::string& key);  // the key of the setting in the file

    [[nodiscard]] Kind kind() const { return m_kind; }
    void draw(QPainter& painter, const QRectF& box) const;
    [[nodiscard]] QIcon icon() const;  // empty if there is no picture, so that all names are aligned

private:
    void drawGeometry(QPainter& painter) const;
    void drawTravel(QPainter& painter) const;
    void drawAzimuthLimits(QPainter& painter) const;
    void drawElevationLimits(QPainter& painter) const;
    void drawHorizon(QPainter& painter) const;
    void drawKeepOut(QPainter& painter) const;
    void drawDirection(QPainter& painter) const;
    void drawGear(QPainter& painter) const;
    void drawPark(QPainter& painter) const;
    void drawSpeed(QPainter& painter) const;
    void drawAcceleration(QPainter& painter) const;
    void drawBeam(QPainter& painter) const;
    void drawNorth(QPainter& painter) const;
    void drawTilt(QPainter& painter) const;
    void drawSun(QPainter& painter) const;

    Kind m_kind = Kind::None;
    bool m_isUpper = false;  // the upper of two ends
};

// The picture of one setting, beside its meaning. Hidden if there is none.
class SettingPictureView : public QWidget
{
    Q_OBJECT

public:
    explicit SettingPictureView(QWidget* parent);

    void setKey(const std::string& key);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::string m_key;
};

}  // namespace boresight::ui

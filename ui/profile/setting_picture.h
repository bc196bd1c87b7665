// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QWidget>

#include <string>

class QPainter;

// Small pictures of what a setting does, one function for each kind. They are drawn in the colours of the current
// theme. The part that the setting moves is in the accent.
namespace boresight::ui {

class SettingPicture
{
public:
    enum class Kind
    {
        None,
        Travel,  // of an axis, as the cable sees it
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

    explicit SettingPicture(const std::string& key);  // as the file calls the setting

    [[nodiscard]] Kind kind() const { return m_kind; }
    void draw(QPainter& painter, const QRectF& box) const;
    [[nodiscard]] QIcon icon() const;  // without a picture an empty one, so that names stand in one column

private:
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
    bool m_isUpper = false;  // of two ends
};

// The picture of one setting, beside its meaning. Hidden without one.
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

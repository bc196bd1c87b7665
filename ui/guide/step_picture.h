// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPainter;

// A picture of what the operator does in a step, in the colours of the theme: the spirit level on the antenna, the ends
// of the travel, or the landmark with a known bearing.
namespace boresight::ui {

class StepPicture : public QWidget
{
    Q_OBJECT

public:
    enum class Scene
    {
        Level,
        Travel,
        North
    };

    explicit StepPicture(Scene scene, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    static void drawLevel(QPainter& painter);
    static void drawTravel(QPainter& painter);
    static void drawNorth(QPainter& painter);

    Scene m_scene;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QPushButton;

// Play and pause, the time slider, and the speeds of a replay. Gui thread.
namespace boresight::ui {

class ReplayPlayer;
class TimeSlider;
class ValueLabel;

class PlayBar : public QWidget
{
    Q_OBJECT

public:
    // `marks` are the moments at which a motion began. The player must outlive the bar.
    PlayBar(ReplayPlayer& player, const std::vector<UtcTime>& marks, QWidget* parent = nullptr);

    [[nodiscard]] TimeSlider& slider() { return *m_slider; }

private:
    [[nodiscard]] QWidget* makeSpeeds();
    void showMoment();
    void showState();

    ReplayPlayer& m_player;
    QPushButton* m_play;
    TimeSlider* m_slider;
    ValueLabel* m_passed;  // of the length of the recording
    QButtonGroup* m_speeds;
};

}  // namespace boresight::ui

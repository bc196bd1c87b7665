// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <QWidget>

#include <array>

class QGridLayout;

// Step 3 of finding north: points of known direction, from Sun, Moon, a landmark or the peak of the received power. The
// pad is that of the Jog panel, in steps only: while a body is tracked the steps trim. While the Sun is chosen, the
// warning about eyes and feed is shown.
namespace boresight::ui {

class BodyBox;
class ChoiceButton;
class JogPad;
class LandmarkBox;
class RequestDesk;
class ScanBox;
class TouchCombo;
class ValueLabel;

class BodyPage : public QWidget
{
    Q_OBJECT

public:
    BodyPage(const Clock& clock, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void beat();  // called a few times a second

private:
    enum class Aim
    {
        Sun,
        Moon,
        Landmark,
        Scan
    };

    void build();
    [[nodiscard]] QLayout* makeChoices();
    [[nodiscard]] QWidget* makeBoxes();
    void fillSteps();
    void choose(Aim aim);
    void chooseBody(ephemeris::Body body);
    void showWarning();

    StationStatus m_status;
    Aim m_aim = Aim::Sun;
    ValueLabel* m_notice;
    ValueLabel* m_warning;
    JogPad* m_pad;
    BodyBox* m_body;
    LandmarkBox* m_landmark;
    ScanBox* m_scan;
    QWidget* m_boxes;
    QGridLayout* m_grid;
    TouchCombo* m_step;
    std::array<ChoiceButton*, 4> m_choices{};  // by Aim
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/kit/asking_panel.h"

class QTabWidget;

// Finding north and checking it, in five numbered steps: the average of the sensor, the compass swing, points of known
// direction, the pointing model from the points, and the history. None of the steps changes anything. The proposal is
// shown below all of them, with Apply, Undo and Redo. Before an unreliable result is applied the panel asks.
namespace boresight::ui {

class BodyPage;
class CalibrationBar;
class HistoryPage;
class ModelPage;
class ProfileDraft;
class SensorPage;
class SwingPage;

enum class CalibrationStep
{
    Sensor,
    Swing,
    Body,
    Model,
    History
};

class CalibrationPanel : public AskingPanel
{
    Q_OBJECT

public:
    CalibrationPanel(const Clock& clock, RequestDesk& desk, ProfileDraft& draft, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void go(CalibrationStep step);
    void beat();  // called a few times a second

Q_SIGNALS:
    void settingsWanted(const QString& words);  // settings of the profile with these words in their name or meaning

private:
    void addStep(QWidget& page, const QString& name, const QString& help);

    StationStatus m_status;
    QTabWidget* m_steps;
    SensorPage* m_sensor;
    SwingPage* m_swing;
    BodyPage* m_body;
    ModelPage* m_model;
    HistoryPage* m_history;
    CalibrationBar* m_bar;
};

}  // namespace boresight::ui

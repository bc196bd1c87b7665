// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <QWidget>

class QTabWidget;

// Finding north and believing it, in five numbered steps: the sensor's average, the compass swing, points of known
// direction, the pointing model of them, and what was applied before. None of them changes anything; below all of them
// stands what is proposed, with Apply, Undo and Redo.
namespace boresight::ui {

class BodyPage;
class CalibrationBar;
class HistoryPage;
class ModelPage;
class ProfileDraft;
class RequestDesk;
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

class CalibrationPanel : public QWidget
{
    Q_OBJECT

public:
    CalibrationPanel(const Clock& clock, RequestDesk& desk, ProfileDraft& draft, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void go(CalibrationStep step);
    void beat();  // a few times a second

Q_SIGNALS:
    void settingsWanted(const QString& words);  // of the profile, that have these in their name or meaning

private:
    void addStep(QWidget& page, const QString& name, const QString& help);

    QTabWidget* m_steps;
    SensorPage* m_sensor;
    SwingPage* m_swing;
    BodyPage* m_body;
    ModelPage* m_model;
    HistoryPage* m_history;
    CalibrationBar* m_bar;
};

}  // namespace boresight::ui

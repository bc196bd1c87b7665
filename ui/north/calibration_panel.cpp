// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/calibration_panel.h"

#include "ui/kit/page_room.h"
#include "ui/kit/theme.h"
#include "ui/north/body_page.h"
#include "ui/north/calibration_bar.h"
#include "ui/north/history_page.h"
#include "ui/north/model_page.h"
#include "ui/north/sensor_page.h"
#include "ui/north/swing_page.h"

#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace boresight::ui {

CalibrationPanel::CalibrationPanel(const Clock& clock, RequestDesk& desk, ProfileDraft& draft, QWidget* parent)
    : AskingPanel(desk, parent),
      m_steps(new QTabWidget(this)),
      m_sensor(new SensorPage(desk, draft, this)),
      m_swing(new SwingPage(desk, this)),
      m_body(new BodyPage(clock, desk, this)),
      m_model(new ModelPage(desk, this)),
      m_history(new HistoryPage(desk, this)),
      m_bar(new CalibrationBar(desk, this))
{
    m_steps->setFont(fonts::label());
    m_steps->setDocumentMode(true);
    m_steps->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // a low window scrolls the page of the step
    m_steps->setMinimumHeight(m_steps->tabBar()->sizeHint().height());
    m_steps->setAccessibleName(tr("Steps of finding north"));
    connect(m_sensor, &SensorPage::settingsWanted, this, &CalibrationPanel::settingsWanted);
    addStep(*m_sensor, tr("1 Sensor"), tr("North from the sensor while the mount stands still, to a few degrees"));
    addStep(*m_swing, tr("2 Swing"), tr("Compass swing: north, compass error of the sensor and tilt of the axis"));
    addStep(*m_body, tr("3 Sun/Moon"), tr("Points of known direction: Sun, Moon, a landmark, the peak of the power"));
    addStep(*m_model, tr("4 Model"), tr("The pointing model of these points, with their residuals"));
    addStep(*m_history, tr("5 History"), tr("What was applied before"));
    connect(m_bar, &CalibrationBar::confirmationWanted, this,
            [this](const Question& question) { askFirst(question, m_status); });
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(0, 0, 0, 2);
    column->setSpacing(4);
    column->addWidget(m_steps, 1);
    column->addWidget(m_bar);
}

// Only the page scrolls in a low window. The tabs and the bar with Apply stay in sight.
void CalibrationPanel::addStep(QWidget& page, const QString& name, const QString& help)
{
    m_steps->setTabToolTip(addScrollingPage(*m_steps, page, name), help);
}

void CalibrationPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    m_sensor->showStatus(status);
    m_swing->showStatus(status);
    m_body->showStatus(status);
    m_model->showStatus(status);
    m_history->showStatus(status);
    m_bar->showStatus(status);
    showWhetherPossible(status);
}

void CalibrationPanel::go(CalibrationStep step)
{
    m_steps->setCurrentIndex(static_cast<int>(step));
}

void CalibrationPanel::beat()
{
    m_body->beat();
}

}  // namespace boresight::ui

#include "moc_calibration_panel.cpp"

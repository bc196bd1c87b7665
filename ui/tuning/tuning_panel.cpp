// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning_panel.h"

#include "ui/kit/axes.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/page_room.h"
#include "ui/tuning/gains_page.h"
#include "ui/tuning/measure_page.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <tuple>

namespace boresight::ui {

TuningPanel::TuningPanel(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_azimuth(new ChoiceButton(tr("Azimuth"), tr("Tune the azimuth axis"), this)),
      m_elevation(new ChoiceButton(tr("Elevation"), tr("Tune the elevation axis"), this)),
      m_measureChoice(new ChoiceButton(tr("Measure"), tr("Runs and their figures"), this)),
      m_gainsChoice(new ChoiceButton(tr("Gains"), tr("The gains of the drive"), this)),
      m_pages(new QStackedWidget(this)),
      m_measure(new MeasurePage(desk, this)),
      m_gains(new GainsPage(desk, this))
{
    build();
    connect(m_azimuth, &QToolButton::clicked, this, [this] { setAxis(Axis::Azimuth); });
    connect(m_elevation, &QToolButton::clicked, this, [this] { setAxis(Axis::Elevation); });
    connect(m_measureChoice, &QToolButton::clicked, this, [this] { showPage(Page::Measure); });
    connect(m_gainsChoice, &QToolButton::clicked, this, [this] { showPage(Page::Gains); });
    connect(m_measure, &MeasurePage::gainsWanted, this, [this] { showPage(Page::Gains); });
    m_azimuth->setChecked(true);
    showPage(Page::Measure);
}

void TuningPanel::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (const auto& [one, other] : {std::pair(m_azimuth, m_elevation), std::pair(m_measureChoice, m_gainsChoice)}) {
        auto* const group = new QButtonGroup(this);
        for (ChoiceButton* const button : {one, other}) {
            group->addButton(button);
            button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
            row->addWidget(button);
        }
    }
    m_pages->addWidget(m_measure);
    m_pages->addWidget(m_gains);
    keepHeightOfShownPage(*m_pages);
    column->addLayout(row);
    column->addWidget(m_pages, 1);
}

void TuningPanel::setAxis(Axis axis)
{
    m_measure->setAxis(axis);
    m_gains->setAxis(axis);
}

void TuningPanel::showPage(Page page)
{
    const bool gains = page == Page::Gains;
    m_pages->setCurrentWidget(gains ? static_cast<QWidget*>(m_gains) : m_measure);
    (gains ? m_gainsChoice : m_measureChoice)->setChecked(true);
}

void TuningPanel::leaveMissingAxis()
{
    for (const auto& [gone, other, axis] :
         {std::tuple(m_azimuth, m_elevation, Axis::Elevation), std::tuple(m_elevation, m_azimuth, Axis::Azimuth)}) {
        if (gone->isChecked() && !gone->isEnabled() && other->isEnabled()) {
            other->setChecked(true);
            setAxis(axis);
            return;
        }
    }
}

void TuningPanel::showStatus(const StationStatus& status)
{
    // A mount may have one axis, or one with such a drive.
    m_azimuth->setEnabled(driveOf(status, Axis::Azimuth).present);
    m_elevation->setEnabled(driveOf(status, Axis::Elevation).present);
    leaveMissingAxis();
    m_measure->showStatus(status);
    m_gains->showStatus(status);
}

}  // namespace boresight::ui

#include "moc_tuning_panel.cpp"

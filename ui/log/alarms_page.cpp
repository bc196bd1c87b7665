// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log/alarms_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/lines_view.h"
#include "ui/log/alarm_model.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

AlarmsPage::AlarmsPage(RequestDesk& desk, bool sound, QWidget* parent)
    : QWidget(parent),
      m_model(new AlarmModel(this)),
      m_order(new AlarmOrder(this)),
      m_view(new LinesView(tr("Alarms"), QStringLiteral("boresight-alarms.txt"), *m_order, this)),
      m_acknowledge(
          new CommandButton(tr("Acknowledge"), tr("Acknowledge the selected alarm"), desk, m_view->notice(), m_view)),
      m_acknowledgeAll(
          new CommandButton(tr("Acknowledge all"), tr("Acknowledge all alarms (F8)"), desk, m_view->notice(), m_view)),
      m_sound(sound)
{
    m_order->setSourceModel(m_model);
    m_order->sort(0);
    m_view->setColumnRoom(AlarmModel::Time, QStringLiteral("00:00:00"));
    m_view->setColumnRoom(AlarmModel::State, tr("active"));
    m_view->setColumnRoom(AlarmModel::Acknowledged, tr("Ackn."));
    m_acknowledge->setAccessibleName(tr("Acknowledge the selected alarm"));
    m_view->addControl(*m_acknowledge);
    m_view->addControl(*m_acknowledgeAll);
    addSound();
    connect(m_acknowledge, &QPushButton::clicked, this, &AlarmsPage::acknowledgeSelected);
    connect(m_acknowledgeAll, &QPushButton::clicked, this,
            [this] { m_acknowledgeAll->ask(request::AcknowledgeAlarms{}); });
    connect(m_view, &LinesView::currentChanged, this, &AlarmsPage::blockAcknowledge);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
}

void AlarmsPage::addSound()
{
    auto* const sound = new QCheckBox(tr("Sound"), m_view);
    sound->setAccessibleName(tr("Sound at a new alarm"));
    sound->setToolTip(tr("Sound once at each new alarm"));
    sound->setChecked(m_sound);
    connect(sound, &QCheckBox::toggled, this, [this](bool on) {
        m_sound = on;
        Q_EMIT soundChanged(on);
    });
    m_view->addControl(*sound, 1);
}

void AlarmsPage::showStatus(const StationStatus& status)
{
    const bool raised = m_model->take(status);
    if (raised && m_sound) {
        Q_EMIT beepWanted();
    }
    // The selection stays on an active alarm that the operator is reading.
    const std::optional<int> selected = selectedRow();
    if (m_order->rowCount() > 0 && (!selected || (raised && !m_model->seen(*selected).place))) {
        m_view->select(0);
    }
    const bool waiting = std::ranges::any_of(status.alarms, [](const Alarm& alarm) { return !alarm.acknowledged; });
    m_acknowledgeAll->setBlocked(waiting ? QString() : tr("All alarms are acknowledged."));
    blockAcknowledge();
}

std::optional<int> AlarmsPage::selectedRow() const
{
    const QModelIndex current = m_view->current();
    return current.isValid() ? std::optional(m_order->mapToSource(current).row()) : std::nullopt;
}

QString AlarmsPage::whyNotSelected() const
{
    const std::optional<int> row = selectedRow();
    if (!row) {
        return tr("No alarm is selected.");
    }
    const SeenAlarm& seen = m_model->seen(*row);
    if (seen.alarm.acknowledged) {
        return tr("This alarm is acknowledged.");
    }
    return seen.place ? QString() : tr("This alarm is over.");
}

void AlarmsPage::blockAcknowledge()
{
    m_acknowledge->setBlocked(whyNotSelected());
}

void AlarmsPage::acknowledgeSelected()
{
    if (const std::optional<int> row = selectedRow()) {
        m_acknowledge->ask(request::AcknowledgeAlarm{m_model->seen(*row).alarm.id});
    }
}

}  // namespace boresight::ui

#include "moc_alarms_page.cpp"

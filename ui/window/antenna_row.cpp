// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/antenna_row.h"

#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/theme.h"
#include "ui/kit/touch_combo.h"
#include "ui/kit/value_label.h"

#include <QAbstractItemView>
#include <QHBoxLayout>

namespace boresight::ui {

namespace {

QStringList namesOf(const profile::Profile& profile)
{
    QStringList names;
    for (const pointing::Antenna& one : profile.allAntennas()) {
        names << QString::fromStdString(one.name);
    }
    return names;
}

}  // namespace

AntennaRow::AntennaRow(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_notice(notice),
      m_antennas(new TouchCombo(tr("Antenna"), {}, this)),
      m_beam(new ValueLabel(tr("Beam of the antenna"), fonts::label(), tr("beam %1").arg(angleText(888.88_deg)), this)),
      m_help(tr("The antenna in use. All directions are those of its beam."))
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(makeCaption(tr("Antenna"), this));
    row->addWidget(m_antennas, 1);
    row->addWidget(m_beam);
    QPushButton* const edit = makePushButton(
        {.text = tr("Edit"), .name = tr("Edit the antennas"), .help = tr("Add, name, measure and remove antennas")},
        this);
    row->addWidget(edit);
    connect(edit, &QPushButton::clicked, this, &AntennaRow::editWanted);
    connect(m_antennas, &QComboBox::activated, this, &AntennaRow::choose);
    hide();
}

void AntennaRow::showStatus(const StationStatus& status)
{
    if (const QStringList names = namesOf(*status.profile); names != m_names) {
        m_names = names;
        m_antennas->setLines(names);
        setVisible(hasChoice());
    }
    m_inUse = QString::fromStdString(status.antenna);
    if (!m_antennas->view()->isVisible()) {  // otherwise the list would move away below the finger
        m_antennas->setCurrentIndex(static_cast<int>(m_names.indexOf(m_inUse)));
    }
    m_beam->setValue(tr("beam %1").arg(angleText(antennaOf(status).beamWidth)), Tone::Secondary);
    const QString& why = status.permissions.reason(Action::UseAntenna);
    m_antennas->setEnabled(why.isEmpty());
    m_antennas->setToolTip(why.isEmpty() ? m_help : why);
}

// Until the station has answered, the row keeps showing the antenna in use.
void AntennaRow::choose(int index)
{
    const QString name = m_names.value(index);
    m_antennas->setCurrentIndex(static_cast<int>(m_names.indexOf(m_inUse)));
    if (name == m_inUse) {
        return;
    }
    m_desk.send(request::UseAntenna{name.toStdString()}, this, [this](const std::optional<Error>& error) {
        m_notice.setValue(error ? tr("Antenna: %1").arg(error->text) : QString(), Tone::Warning,
                          error ? Symbol::Warning : Symbol::None);
    });
}

}  // namespace boresight::ui

#include "moc_antenna_row.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/sensor_offsets_row.h"

#include "core/base/text.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <QHBoxLayout>

namespace boresight::ui {

namespace {
constexpr int kLinesOfOffsets = 3;
}

SensorOffsetsRow::SensorOffsetsRow(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_change(draft, desk),
      m_text(new ValueLabel(tr("Sensor offsets of the control box"), fonts::label(), {}, this)),
      m_save(new CommandButton(tr("Save offsets"),
                               tr("Save the offsets with the profile. Boresight compares them at each connection. "
                                  "Nothing is written to the box."),
                               desk, notice, this))
{
    m_text->setStretching(true);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_text, 1);
    row->addWidget(m_save);
    setVisible(false);
    connect(m_save, &QPushButton::clicked, this, [this] { m_change.ask(*m_save, edit()); });
}

ProfileChange::Edit SensorOffsetsRow::edit() const
{
    return [reported = m_reported](profile::Profile& profile) { profile.rotator.sensorOffsets = reported; };
}

void SensorOffsetsRow::showStatus(const StationStatus& status)
{
    m_reported = status.line.sensorOffsets;
    const QString saved = toQString(m_change.applied().rotator.sensorOffsets);
    setVisible(!m_reported.empty() || !saved.isEmpty());
    const bool isSaved = m_change.isAlready(edit());
    if (m_reported.empty()) {
        m_text->setLines(kLinesOfOffsets);
        m_text->setValue(tr("Sensor offsets: not reported. The box reports them while all digits are 3."),
                         Tone::Secondary);
    } else if (isSaved || saved.isEmpty()) {
        m_text->setLines(kLinesOfOffsets);
        m_text->setValue((isSaved ? tr("Sensor offsets, saved: %1") : tr("Sensor offsets, not saved: %1"))
                             .arg(toQString(m_reported)),
                         Tone::Secondary);
    } else {
        m_text->setLines(2 * kLinesOfOffsets);  // what differs must be readable
        m_text->setValue(tr("Sensor offsets: %1. Saved: %2").arg(toQString(m_reported), saved), Tone::Warning,
                         Symbol::Warning);
    }
    m_save->setBlocked(m_reported.empty() ? tr("The box has not reported its offsets.")
                       : isSaved          ? tr("These offsets are saved.")
                                          : m_change.whyNot(status, edit()));
}

}  // namespace boresight::ui

#include "moc_sensor_offsets_row.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/note_line.h"

#include "ui/kit/value_label.h"
#include "ui/link/profile_draft.h"

#include <QFocusEvent>

namespace boresight::ui {

NoteLine::NoteLine(ProfileDraft& draft, ValueLabel& notice, QWidget* parent)
    : QLineEdit(parent), m_draft(draft), m_notice(notice)
{
    setFont(fonts::label());
    setAccessibleName(tr("Note about the satellite"));
    setPlaceholderText(tr("Note: frequency, polarisation, …"));
    setToolTip(tr("A note about this satellite. Enter stores the note. Esc restores the old note"));
    setMaxLength(static_cast<int>(orbit::kLongestNote));
    setMinimumHeight(kRowHeight);
    connect(this, &QLineEdit::returnPressed, this, &NoteLine::store);
}

void NoteLine::show(const std::optional<int>& satellite, const orbit::SatelliteMarks& marks)
{
    if (isModified()) {
        return;
    }
    const QString note = satellite ? QString::fromStdString(orbit::noteOf(marks, *satellite)) : QString();
    if (satellite != m_satellite || note != m_stored) {
        m_satellite = satellite;
        m_stored = note;
        setText(note);
        setCursorPosition(0);
    }
    setEnabled(satellite.has_value());
}

// After Esc the focus leaves without a new target (OtherFocusReason). Then the stored text returns.
void NoteLine::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::OtherFocusReason) {
        takeBack();
    } else if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) {
        store();
    }
    Q_EMIT left();
}

void NoteLine::takeBack()
{
    setText(m_stored);
    setModified(false);
}

// If the station refuses the note, the typed text stays.
void NoteLine::store()
{
    const QString note = text().trimmed();
    if (!m_satellite || !isModified()) {
        return;
    }
    if (note == m_stored) {
        takeBack();
        return;
    }
    m_draft.applyAlone(
        [satellite = *m_satellite, note](profile::Profile& profile) {
            orbit::setNote(profile.satellites, satellite, note.toStdString());
        },
        this,
        [this, note](const std::optional<Error>& error) {
            m_notice.setValue(error ? tr("Note: %1").arg(error->text) : QString(), error ? Tone::Warning : Tone::Normal,
                              error ? Symbol::Warning : Symbol::None);
            if (!error && text().trimmed() == note) {
                m_stored = note;
                takeBack();
            }
        });
}

}  // namespace boresight::ui

#include "moc_note_line.cpp"

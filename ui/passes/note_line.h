// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"

#include <QLineEdit>

#include <optional>

// The note of a satellite in the profile, as an editable line. Enter, or leaving the line, stores the note. Esc
// restores the stored text. While the operator types, the line stays with the satellite for which the text was begun.
// Gui thread.
namespace boresight::ui {

class ProfileDraft;
class ValueLabel;

class NoteLine : public QLineEdit
{
    Q_OBJECT

public:
    NoteLine(ProfileDraft& draft, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: no satellite is selected.
    void show(const std::optional<int>& satellite, const orbit::SatelliteMarks& marks);

Q_SIGNALS:
    void left();

protected:
    void focusOutEvent(QFocusEvent* event) override;

private:
    void store();
    void takeBack();

    ProfileDraft& m_draft;
    ValueLabel& m_notice;
    std::optional<int> m_satellite;
    QString m_stored;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"

#include <QLineEdit>

#include <optional>

// The note of a satellite in the profile, in a line that can be edited. Enter, or leaving the line, stores it. Esc
// takes back what was typed. What is being typed stays until then, and belongs to the satellite for which it was begun.
// Gui thread.
namespace boresight::ui {

class ProfileDraft;
class ValueLabel;

class NoteLine : public QLineEdit
{
    Q_OBJECT

public:
    NoteLine(ProfileDraft& draft, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: none is selected.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/direction_question.h"

#include <QWidget>

// Named directions of the profile: go to one, save the present direction under a name, delete one. A change of the list
// is applied alone. Other edits of the profile stay edits. Selecting a name moves nothing.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class TouchCombo;
class ValueLabel;

class PresetBar : public QWidget
{
    Q_OBJECT

public:
    PresetBar(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    [[nodiscard]] QString typedName() const;
    [[nodiscard]] const profile::Preset* chosen() const;  // by the name in the field; null: there is none
    [[nodiscard]] QString whyNoGo() const;
    [[nodiscard]] QString whyNoSave() const;
    void showPresets();
    void showPermissions();
    void lookUp();  // finds the direction of the name in the field, and whether the mount may go there
    void go();
    void save();
    void remove();

    ProfileDraft& m_draft;
    TouchCombo* m_names;
    CommandButton* m_go;
    CommandButton* m_save;
    CommandButton* m_delete;
    DirectionQuestion m_question;  // about the chosen one
    StationStatus m_status;
};

}  // namespace boresight::ui

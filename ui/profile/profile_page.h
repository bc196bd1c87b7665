// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"
#include "ui/link/profile_draft.h"
#include "ui/profile/stored_mounts.h"

#include <functional>

class QComboBox;
class QMenu;
class QPushButton;

// The profile whole: every setting of the mount in force, and the mounts that are kept in the store. Choosing one in
// the list does nothing; Switch, and all that writes a file, asks first and shows what would change.
namespace boresight::ui {

class AntennaPage;
class ProfileDraftBar;
class SettingsView;

class ProfilePage : public AskingPanel
{
    Q_OBJECT

public:
    // `configDir` is the folder of the profile store; empty: there is none.
    ProfilePage(ProfileDraft& draft, RequestDesk& desk, const QString& configDir, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void showAntennas();              // their table in the place of the settings
    void seek(const QString& words);  // the settings that have them in their name or meaning

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    QWidget* makeMountRow();
    void addAction(const QString& text, const std::function<void()>& act);
    void showMounts();
    void showChoice();
    void showSettings();
    void chooseImport();
    void chooseExport();
    [[nodiscard]] profile::StoredProfile chosen() const;
    [[nodiscard]] QString whyNoSwitch() const;
    void tell(const QString& text);
    void warn(const QString& reason);

    ProfileDraft& m_draft;
    StationStatus m_status;
    StoredMounts m_mounts;
    QComboBox* m_choice;
    QPushButton* m_menuButton;
    QMenu* m_menu;
    SettingsView* m_settings;
    AntennaPage* m_antennas;  // or these are shown
    QWidget* m_mountRow = nullptr;
    ValueLabel* m_notice;
    CommandButton* m_switch;
    ProfileDraftBar* m_bar;
};

}  // namespace boresight::ui

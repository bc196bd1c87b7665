// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"
#include "ui/link/profile_draft.h"
#include "ui/profile/stored_mounts.h"

#include <functional>

class QComboBox;
class QMenu;
class QPushButton;

// The complete profile: every setting of the mount in effect, and the mounts in the store. Selecting a mount in the
// list does nothing. Switch, and every action that writes a file, asks first and shows the changes.
namespace boresight::ui {

class AntennaPage;
class ProfileDraftBar;
class SettingsView;

class ProfilePage : public AskingPanel
{
    Q_OBJECT

public:
    // `configDir` is the folder of the profile store. Empty: there is none.
    ProfilePage(ProfileDraft& draft, RequestDesk& desk, const QString& configDir, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void showAntennas();              // shows their table in place of the settings
    void seek(const QString& words);  // shows the settings with these words in their name or meaning

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
    AntennaPage* m_antennas;  // shown in place of the settings
    QWidget* m_mountRow = nullptr;
    ValueLabel* m_notice;
    CommandButton* m_switch;
    ProfileDraftBar* m_bar;
};

}  // namespace boresight::ui

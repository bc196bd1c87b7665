// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile_store.h"
#include "ui/kit/asking_panel.h"
#include "ui/kit/file_worker.h"
#include "ui/link/profile_draft.h"

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QMenu;
class QPushButton;

// The profile whole: every setting of the mount in force, and the mounts that are kept in the store. Choosing one in
// the list does nothing; Switch, and all that writes a file, asks first and shows what would change. Changes of the
// mount in force go through the draft and the station like any other edit; files are read and written beside the gui
// thread.
namespace boresight::ui {

class ProfileDraftBar;
class SettingsView;

class ProfilePage : public AskingPanel
{
    Q_OBJECT

public:
    // `configDir` is the folder of the profile store; empty: there is none.
    ProfilePage(ProfileDraft& draft, RequestDesk& desk, const QString& configDir, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void seek(const QString& words);  // the settings that have them in their name or meaning

protected:
    void showEvent(QShowEvent* event) override;

private:
    using Perform = std::function<void(const QString& typed)>;
    using Outcome = std::function<Result<>()>;

    void build();
    QWidget* makeMountRow();
    void addAction(const QString& text, void (ProfilePage::*act)());
    void refresh();
    void showMounts(const std::vector<profile::StoredProfile>& mounts);
    void showChoice();
    [[nodiscard]] profile::StoredProfile chosen() const;
    [[nodiscard]] bool isInForce(const profile::StoredProfile& mount) const;
    [[nodiscard]] const profile::StoredProfile* stored(const QString& mountName) const;
    [[nodiscard]] QString whyNoSwitch() const;

    void switchTo();
    void duplicate();
    void rename();
    void remove();
    void chooseImport();
    void import(const QString& file);
    void askImport(const profile::Profile& read);
    void askOverwrite(const profile::Profile& read, const profile::StoredProfile& mount);
    void chooseExport();
    void exportTo(const QString& file);
    void takeBack();
    void askTakeBack(const profile::StoredProfile& mount, const profile::Profile& now, const profile::Profile& before);
    void takeOver(const profile::Profile& from, const std::vector<std::string>& keys);

    void load(const QString& path, const std::function<void(const profile::Profile&)>& then);
    void write(const Outcome& work, const QString& done);
    void ask(const QString& title, const QString& text, const QString& act, const Perform& perform);
    void tell(const QString& text);
    void warn(const QString& reason);

    ProfileDraft& m_draft;
    bool m_hasStore;
    profile::ProfileStore m_store;
    std::vector<profile::StoredProfile> m_mounts;
    StationStatus m_status;
    QComboBox* m_choice;
    QPushButton* m_menuButton;
    QMenu* m_menu;
    SettingsView* m_settings;
    ValueLabel* m_notice;
    CommandButton* m_switch;
    ProfileDraftBar* m_bar;
    FileWorker m_files;  // last, so that it ends first
};

}  // namespace boresight::ui

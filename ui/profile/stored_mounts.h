// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/profile/profile_store.h"
#include "ui/kit/asking_panel.h"
#include "ui/kit/file_worker.h"
#include "ui/link/profile_draft.h"

#include <QObject>

#include <functional>
#include <string>
#include <vector>

// The mounts in the store, and the actions on a whole profile: switch, duplicate, import, undo and others. Every action
// that writes a file or changes the mount in effect asks first and shows the changes. Changes of the mount in effect go
// through the draft and the station like any other edit. Lives on the gui thread. Files are read and written on a
// worker.
namespace boresight::ui {

class StoredMounts : public QObject
{
    Q_OBJECT

public:
    // `configDir` is the folder of the profile store. Empty: there is none.
    StoredMounts(ProfileDraft& draft, const QString& configDir);

    void showStatus(const StationStatus& status);
    void refresh();  // another program may have changed the folder

    // The mount in effect is in the list even before it has a file.
    [[nodiscard]] const std::vector<profile::StoredProfile>& list() const { return m_mounts; }
    [[nodiscard]] bool isInForce(const profile::StoredProfile& mount) const;

    void switchTo(const profile::StoredProfile& mount);
    void duplicate(const profile::StoredProfile& mount);
    void rename(const profile::StoredProfile& mount);
    void remove(const profile::StoredProfile& mount);
    void takeBack(const profile::StoredProfile& mount);  // undoes the last saved change
    void importFile(const QString& file);
    void exportTo(const QString& file, const profile::StoredProfile& mount);

Q_SIGNALS:
    void listed();  // the list was read again
    void asked(const boresight::ui::Question& question);
    void done(const QString& outcome);
    void failed(const QString& reason);

private:
    using Perform = std::function<void(const QString& typed)>;
    using Outcome = std::function<Result<>()>;

    void takeList(std::vector<profile::StoredProfile> mounts);
    [[nodiscard]] const profile::StoredProfile* stored(const QString& mountName) const;

    void askImport(const profile::Profile& read);
    void askOverwrite(const profile::Profile& read, const profile::StoredProfile& mount, const profile::Profile& kept);
    void askTakeBack(const profile::StoredProfile& mount, const profile::Profile& now, const profile::Profile& before);
    void takeOver(const profile::Profile& from, const std::vector<std::string>& keys);

    void load(const QString& path, const std::function<void(const profile::Profile&)>& then);
    void write(const Outcome& work, const QString& outcome);
    void ask(const QString& title, const QString& text, const QString& act, const Perform& perform);

    ProfileDraft& m_draft;
    bool m_hasStore;
    profile::ProfileStore m_store;
    std::vector<profile::StoredProfile> m_mounts;
    std::string m_inForce;  // the name of the mount
    bool m_simulated = false;
    FileWorker m_files;  // last, so that it is destroyed first
};

}  // namespace boresight::ui

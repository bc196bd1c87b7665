// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

#include <optional>
#include <vector>

// The profiles of several mounts: FOLDER/profiles/MOUNT.toml. One of them is current. FOLDER/profiles/current contains
// the name of its file. No two mounts have the same name, because the journal of a mount is kept under its name. A
// profile is identified by the path of its file. The class keeps nothing in memory. Each call reads the folder again,
// so two programs can share it. Blocking file access: not on the gui thread and not on the station thread.
namespace boresight::profile {

struct StoredProfile
{
    QString path;
    QString mountName;  // the name of the mount, or of the file if the file cannot be read
    bool isCurrent = false;
    QString problem;  // why the file cannot be read; empty: it can be read

    bool operator==(const StoredProfile&) const = default;
};

class ProfileStore
{
public:
    explicit ProfileStore(const QString& folder);

    // Sorted by the names of the mounts.
    [[nodiscard]] std::vector<StoredProfile> list() const;

    // The profile to start with. Empty if there is none. If FOLDER/profile.toml exists, it is first moved into the
    // store and becomes the current profile. Older versions wrote this file, or the operator put it there.
    [[nodiscard]] Result<std::optional<QString>> findCurrent() const;
    [[nodiscard]] Result<> setCurrent(const QString& path) const;

    // Stores the profile of a new mount and returns its path. Refused if a mount of that name exists.
    [[nodiscard]] Result<QString> add(const Profile& profile) const;
    [[nodiscard]] Result<QString> duplicate(const QString& path, const QString& newMountName) const;
    [[nodiscard]] Result<QString> importFile(const QString& source) const;

    // Saves the profile and keeps its previous version. undo() exchanges the two versions, so a second undo() restores
    // the newer one (profile_history.h).
    [[nodiscard]] Result<> save(const Profile& profile, const QString& path) const;
    [[nodiscard]] Result<Profile> undo(const QString& path) const;
    // Copies the TOML file to `target` and replaces an existing file.
    [[nodiscard]] Result<> exportFile(const QString& path, const QString& target) const;
    // Renames the file to MOUNT.toml.removed. Refused if it is the current profile.
    [[nodiscard]] Result<> remove(const QString& path) const;

private:
    [[nodiscard]] QString currentFile() const;
    [[nodiscard]] QString freePath(const QString& mountName) const;
    [[nodiscard]] Result<> checkIsMine(const QString& path) const;
    [[nodiscard]] Result<> checkNameIsFree(const std::string& mountName, const QString& ownPath) const;
    [[nodiscard]] Result<QString> takeIn(const QString& single) const;

    QString m_folder;    // FOLDER
    QString m_profiles;  // FOLDER/profiles
};

}  // namespace boresight::profile

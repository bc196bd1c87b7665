// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

#include <optional>
#include <vector>

// The profiles of several mounts: FOLDER/profiles/MOUNT.toml, one of them current (its file's name is in
// FOLDER/profiles/current). Each mount's name is there once, because what a mount remembers is kept under its name. A
// profile is known here by its file's path. Keeps nothing in memory: each call looks at the folder again, so that two
// programs can share it. Blocking file access: not on the gui thread, nor the station's.
namespace boresight::profile {

struct StoredProfile
{
    QString path;
    QString mountName;  // or the file's, if it cannot be read
    bool isCurrent = false;
    QString problem;  // why it cannot be read; empty: it can

    bool operator==(const StoredProfile&) const = default;
};

class ProfileStore
{
public:
    explicit ProfileStore(const QString& folder);

    // By the mounts' names.
    [[nodiscard]] std::vector<StoredProfile> list() const;

    // The one to start with; empty if there is none at all. A FOLDER/profile.toml, where the only profile was once, or
    // which somebody has put there, is taken in first, as the current one.
    [[nodiscard]] Result<std::optional<QString>> findCurrent() const;
    [[nodiscard]] Result<> setCurrent(const QString& path) const;

    // A new mount; its path. Refused: there is one of that name.
    [[nodiscard]] Result<QString> add(const Profile& profile) const;
    [[nodiscard]] Result<QString> duplicate(const QString& path, const QString& newMountName) const;
    [[nodiscard]] Result<QString> importFile(const QString& source) const;

    // Keeps the previous version; undo() brings it back, and again the newer one (profile_history.h).
    [[nodiscard]] Result<> save(const Profile& profile, const QString& path) const;
    [[nodiscard]] Result<Profile> undo(const QString& path) const;
    // The same TOML file elsewhere; replaces what is there.
    [[nodiscard]] Result<> exportFile(const QString& path, const QString& target) const;
    // Keeps it as MOUNT.toml.removed. Refused: it is the current one.
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

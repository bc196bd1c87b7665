// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/options.h"
#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

#include <string>
#include <vector>

// The profile that the operator applied last, and the file that keeps its changes. This is the file with which the
// station began, or a new mount of the store. Only the keys that the operator has changed are written, so overrides of
// the command line never are. Blocking file access: neither on the gui thread nor on the station thread.
namespace boresight::app {

class KeptProfile
{
public:
    explicit KeptProfile(const Options& options);

    // A station begins with this profile. Changes go to the file `path`. If it is empty, the first change makes a new
    // mount.
    void begin(const profile::Profile& profile, const QString& path);
    // The operator has applied this profile. It counts as applied even if it cannot be written.
    [[nodiscard]] Result<> save(const profile::Profile& wanted);

    [[nodiscard]] const profile::Profile& last() const { return m_last; }
    [[nodiscard]] const QString& path() const { return m_path; }

    // Writes the whole profile over a file in which the mount has the name `nameBefore`. If `path` is empty, the
    // profile becomes a new mount of the store and the current one, and `path` is set.
    [[nodiscard]] Result<> write(const profile::Profile& whole, QString& path, const std::string& nameBefore) const;

private:
    [[nodiscard]] Result<> saveNew(const profile::Profile& wanted, const std::vector<std::string>& keys);
    [[nodiscard]] Result<> saveChanges(const profile::Profile& wanted, std::vector<std::string> keys);

    QString m_configDir;
    Simulation m_asked;                     // of the command line
    std::vector<std::string> m_overridden;  // keys that the command line overrides: never written
    QString m_path;
    profile::Profile m_last;
};

}  // namespace boresight::app

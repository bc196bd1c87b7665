// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/options.h"
#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

#include <string>
#include <vector>

// The profile that the operator applied last, and the file that keeps its changes: the one that the station began with,
// else a new mount of the store. Only the keys that the operator has changed are written, so that what the command line
// overrides is not. Blocking file access: not on the gui thread, nor the station's.
namespace boresight::app {

class KeptProfile
{
public:
    explicit KeptProfile(const Options& options);

    // A station begins with this profile. Its changes go to this file; empty: the first one makes a new mount.
    void begin(const profile::Profile& profile, const QString& path);
    // The operator has applied this. That holds also where it cannot be written.
    [[nodiscard]] Result<> save(const profile::Profile& wanted);

    [[nodiscard]] const profile::Profile& last() const { return m_last; }
    [[nodiscard]] const QString& path() const { return m_path; }

    // The whole profile, over a file in which the mount has the name `nameBefore`. Without a path it becomes a new
    // mount of the store, the current one, and gets its path.
    [[nodiscard]] Result<> write(const profile::Profile& whole, QString& path, const std::string& nameBefore) const;

private:
    [[nodiscard]] Result<> saveNew(const profile::Profile& wanted, const std::vector<std::string>& keys);
    [[nodiscard]] Result<> saveChanges(const profile::Profile& wanted, std::vector<std::string> keys);

    QString m_configDir;
    Simulation m_asked;                     // by the command line
    std::vector<std::string> m_overridden;  // by the command line: never written
    QString m_path;
    profile::Profile m_last;
};

}  // namespace boresight::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnostics/tar_archive.h"
#include "core/messages/station_status.h"

// One archive for a bug report: what the program, the mount and its last minutes were like. It holds no passwords.
// Blocking, and some 10 MB of logs at most: not on the gui thread, nor the station's.
namespace boresight::diagnostics {

struct Snapshot
{
    StationStatus status;      // with the profile in force
    profile::Profile applied;  // the same, with what waits for a reconnect
    QString stateDir;          // with the logs and the mount's memory
    UtcTime when;
};

struct BundleFile
{
    ArchiveFile file;
    QString about;  // one sentence for the README
};

// What a snapshot leads to; files of the state folder that are not there are left out.
[[nodiscard]] std::vector<BundleFile> collect(const Snapshot& snapshot);

// Into one folder of the archive, with a README.txt that says what each file is.
[[nodiscard]] Result<> writeBundle(const QString& path, const std::vector<BundleFile>& files, UtcTime when);

[[nodiscard]] QString proposedName(UtcTime when);  // boresight-20261121T181730Z.tar.gz

}  // namespace boresight::diagnostics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnostics/tar_archive.h"
#include "core/messages/station_status.h"

// One archive for a bug report: the state of the program and the mount, and their last minutes. It contains no
// passwords. Blocking, with at most about 10 MB of logs: neither on the gui thread nor on the station thread.
namespace boresight::diagnostics {

struct Snapshot
{
    StationStatus status;      // includes the profile in force
    profile::Profile applied;  // the profile in force with the changes that wait for a reconnect
    QString stateDir;          // the folder with the logs and the position journal
    UtcTime when;
};

struct BundleFile
{
    ArchiveFile file;
    QString about;  // one sentence for the README
};

// Makes the files from a snapshot. Missing files of the state folder are left out.
[[nodiscard]] std::vector<BundleFile> collect(const Snapshot& snapshot);

// Writes all files into one folder of the archive, with a README.txt that describes each file.
[[nodiscard]] Result<> writeBundle(const QString& path, const std::vector<BundleFile>& files, UtcTime when);

[[nodiscard]] QString proposedName(UtcTime when);  // boresight-20261121T181730Z.tar.gz

}  // namespace boresight::diagnostics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <QByteArray>
#include <QString>

#include <vector>

// Files put together into one .tar.gz. Blocking: not on the gui thread, nor the station's.
namespace boresight::diagnostics {

struct ArchiveFile
{
    QString name;  // with the folder it is to have in the archive
    QByteArray bytes;

    bool operator==(const ArchiveFile&) const = default;
};

// All or nothing: a failure, whose reason names the path, leaves what was there. All files get the time `when`.
[[nodiscard]] Result<> writeArchive(const QString& path, const std::vector<ArchiveFile>& files, UtcTime when);

}  // namespace boresight::diagnostics

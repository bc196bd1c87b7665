// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <QByteArray>
#include <QString>

#include <vector>

// Packs files into one .tar.gz. Blocking: neither on the gui thread nor on the station thread.
namespace boresight::diagnostics {

struct ArchiveFile
{
    QString name;  // path inside the archive, with its folder
    QByteArray bytes;

    bool operator==(const ArchiveFile&) const = default;
};

// All or nothing: after a failure the old archive stays. The reason names the path. All files get the time `when`.
[[nodiscard]] Result<> writeArchive(const QString& path, const std::vector<ArchiveFile>& files, UtcTime when);

}  // namespace boresight::diagnostics

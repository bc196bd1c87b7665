// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFileInfo>
#include <QString>

namespace boresight::fuzz {

// The name of a new folder, in memory if this computer has such a place, because each answer is written to a file.
[[nodiscard]] inline QString memoryFolder(const QString& name)
{
    const QString memory = QStringLiteral("/dev/shm");
    return (QFileInfo::exists(memory) ? memory : QDir::tempPath()) + QLatin1Char('/') + name +
           QStringLiteral("-XXXXXX");
}

}  // namespace boresight::fuzz

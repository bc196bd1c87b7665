// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/stable_port.h"

#include <QDir>
#include <QFileInfo>

namespace boresight {

QString stableNameOf(const QString& port, const QString& namesFolder)
{
    const QString target = QFileInfo(port).canonicalFilePath();
    for (const QFileInfo& entry : QDir(namesFolder).entryInfoList(QDir::System | QDir::Files, QDir::Name)) {
        if (!target.isEmpty() && entry.canonicalFilePath() == target) {
            return entry.absoluteFilePath();
        }
    }
    return {};
}

// The stored device, in any socket. If it is missing: a spare device that has the configured path. Any other device
// with the configured name must be left alone.
QString StablePort::device() const
{
    return m_name.isEmpty() || (!QFileInfo::exists(m_name) && hasSpare()) ? m_path : m_name;
}

bool StablePort::hasSpare() const
{
    return m_isSpare && m_isSpare(QFileInfo(stableNameOf(m_path, m_namesFolder)).fileName());
}

void StablePort::storeName()
{
    if (!QFileInfo(m_path).isSymbolicLink()) {
        const QString name = stableNameOf(device(), m_namesFolder);
        m_name = name.isEmpty() ? m_name : name;
    }
}

}  // namespace boresight

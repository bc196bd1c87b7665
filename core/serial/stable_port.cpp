// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/stable_port.h"

#include <QDir>
#include <QFileInfo>

namespace boresight {

// Both adapters call themselves mjbots_fdcanusb; the maker's name alone covers later ones.
bool isAdapterName(const QString& name)
{
    return name.contains(QLatin1String("mjbots"), Qt::CaseInsensitive) ||
           name.contains(QLatin1String("fdcanusb"), Qt::CaseInsensitive);
}

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

// The stored adapter, wherever it is plugged in now; else a spare one that took its place. Any other device that
// got the configured name must be left alone.
QString StablePort::device() const
{
    const bool useConfigured =
        m_name.isEmpty() ||
        (!QFileInfo::exists(m_name) && isAdapterName(QFileInfo(stableNameOf(m_path, m_namesFolder)).fileName()));
    return useConfigured ? m_path : m_name;
}

void StablePort::storeName()
{
    if (!QFileInfo(m_path).isSymbolicLink()) {
        const QString name = stableNameOf(device(), m_namesFolder);
        m_name = name.isEmpty() ? m_name : name;
    }
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/port_holder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace boresight {
namespace {

bool holds(const QString& process, const QString& target)
{
    const QDir descriptors(QStringLiteral("/proc/%1/fd").arg(process));
    for (const QFileInfo& descriptor : descriptors.entryInfoList(QDir::Files | QDir::System)) {
        if (descriptor.symLinkTarget() == target) {
            return true;
        }
    }
    return false;
}

QString programOf(const QString& process)
{
    QFile file(QStringLiteral("/proc/%1/comm").arg(process));
    const QString name = file.open(QIODevice::ReadOnly) ? QString::fromLocal8Bit(file.readAll()).trimmed() : QString();
    return name.isEmpty() ? QStringLiteral("a program") : name;
}

}  // namespace

std::optional<QString> portHolder(const QString& device)
{
    const QString target = QFileInfo(device).canonicalFilePath();
    const QString self = QString::number(QCoreApplication::applicationPid());
    for (const QString& process : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        bool isProcess = false;
        process.toInt(&isProcess);
        if (isProcess && process != self && !target.isEmpty() && holds(process, target)) {
            return QStringLiteral("%1 (process %2)").arg(programOf(process), process);
        }
    }
    return std::nullopt;
}

}  // namespace boresight

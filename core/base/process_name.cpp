// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/process_name.h"

#include "core/base/text.h"

#include <QFile>

namespace boresight {

QString processText(const QString& name, const QString& number)
{
    return Text::tr("%1 (process %2)").arg(name, number);
}

QString nameOfProcess(const std::string& number)
{
    if (number.empty()) {
        return Text::tr("another program");
    }
    const QString process = QString::fromStdString(number);
    QFile file(QStringLiteral("/proc/%1/comm").arg(process));
    const QString name = file.open(QIODevice::ReadOnly) ? QString::fromLocal8Bit(file.readAll()).trimmed() : QString();
    return processText(name.isEmpty() ? Text::tr("a program") : name, process);
}

}  // namespace boresight

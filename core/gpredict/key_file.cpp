// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gpredict/key_file.h"

#include <QStringList>

namespace boresight::profile {

std::optional<QString> keyFileValue(const QByteArray& text, const QString& group, const QString& key)
{
    const QString heading = QLatin1Char('[') + group + QLatin1Char(']');
    bool isInGroup = false;
    std::optional<QString> value;
    for (const QString& raw : QString::fromUtf8(text).split(QLatin1Char('\n'))) {
        const QString line = raw.trimmed();
        if (line.startsWith(QLatin1Char('['))) {
            isInGroup = line == heading;
        } else if (isInGroup && line.section(QLatin1Char('='), 0, 0).trimmed() == key) {
            value = line.section(QLatin1Char('='), 1).trimmed();
        }
    }
    return value;
}

}  // namespace boresight::profile

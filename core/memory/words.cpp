// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/words.h"

#include "core/base/numbers.h"

namespace boresight::memory {

QString inWords(Angle angle)
{
    return QString::fromStdString(formatFixed(angle.degrees(), 1)) + QStringLiteral("°");
}

// Two units of the smaller kind are still told in it: 90 s, but 2 min.
QString inWords(Seconds time)
{
    struct Unit
    {
        double seconds;
        QString name;
    };
    static const Unit units[] = {{86400.0, QStringLiteral("days")},
                                 {3600.0, QStringLiteral("h")},
                                 {60.0, QStringLiteral("min")},
                                 {1.0, QStringLiteral("s")}};
    for (const Unit& unit : units) {
        if (time.count() >= 2.0 * unit.seconds || unit.seconds == 1.0) {
            return QString::fromStdString(formatFixed(time.count() / unit.seconds, 0)) + u' ' + unit.name;
        }
    }
    return {};
}

}  // namespace boresight::memory

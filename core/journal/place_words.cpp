// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/place_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

namespace boresight::journal {

QString inWords(Angle angle)
{
    return degreesText(angle);
}

// A time below two units is given in the smaller unit: 90 s, but 2 min.
QString inWords(Seconds time)
{
    struct Unit
    {
        double seconds;
        const char* text;
    };
    static constexpr Unit units[] = {{86400.0, QT_TRANSLATE_NOOP("Text", "%1 days")},
                                     {3600.0, QT_TRANSLATE_NOOP("Text", "%1 h")},
                                     {60.0, QT_TRANSLATE_NOOP("Text", "%1 min")},
                                     {1.0, QT_TRANSLATE_NOOP("Text", "%1 s")}};
    for (const Unit& unit : units) {
        if (time.count() >= 2.0 * unit.seconds || unit.seconds == 1.0) {
            return Text::of(unit.text).arg(toQString(formatFixed(time.count() / unit.seconds, 0)));
        }
    }
    return {};
}

}  // namespace boresight::journal

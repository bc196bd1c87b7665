// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/theme.h"

#include <QString>

// The azimuth cable in words: two lines for a corner of the plot, and sentences for a screen reader. Angles are axis
// angles, beyond 360° too.
namespace boresight::ui {

struct CableWords
{
    QString place;   // "cable 335°"; empty: the mount has no azimuth cable
    QString travel;  // "travel -90…450°", that the wrap is unknown, how soon the cable ends, or "at the end"
    QString sentence;
    bool isWarning = false;  // the second line
    Tone tone = Tone::Normal;

    bool operator==(const CableWords&) const = default;
};

[[nodiscard]] CableWords cableWords(const StationStatus& status);
[[nodiscard]] CableWords widestCableWords();

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/theme.h"

#include <QColor>
#include <QRectF>

class QPainter;

// The symbols of the screen. They are drawn and not taken from a font, so that the plot, its legend, the link row and
// the alarm line show the same ones.
namespace boresight::ui {

enum class Symbol
{
    None,
    Healthy,    // ○
    Advisory,   // ●
    Warning,    // ▲
    Alarm,      // ■
    Target,     // ◇
    Commanded,  // ✛, open in the middle
    Actual,     // ●
    Sensor,     // △
    Lost        // ◌, the last known position of a silent mount
};

void drawSymbol(QPainter& painter, Symbol symbol, const QRectF& box, const QColor& colour);

[[nodiscard]] Symbol symbolOf(Severity severity);
[[nodiscard]] Tone toneOf(Severity severity);
// The symbol as a character before a line of text, followed by a gap. An advisory has none, because most lines of a log
// are advisories.
[[nodiscard]] QString characterOf(Severity severity);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/theme.h"

#include <QColor>
#include <QRectF>

class QPainter;

// The shapes of the screen, drawn rather than taken from a font, so that the plot, its legend, the link row and the
// alarm line show the same ones everywhere.
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
    Lost        // ◌, the last known place of a mount that is silent
};

void drawSymbol(QPainter& painter, Symbol symbol, const QRectF& box, const QColor& colour);

[[nodiscard]] Symbol symbolOf(Severity severity);
[[nodiscard]] Tone toneOf(Severity severity);
// The same shape before a line of text, with the gap behind it; an advisory has none: most lines of a log are.
[[nodiscard]] QString characterOf(Severity severity);

}  // namespace boresight::ui

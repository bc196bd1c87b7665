// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

class QColor;
class QPainter;
class QRectF;

// The small pictures on tabs, buttons and menu lines. They are drawn, so that they have any size and always the colours
// of the current theme.
namespace boresight::ui {

enum class ThemeKind;

enum class Glyph
{
    Jog,      // four arrows
    Passes,   // a satellite on its way over the horizon
    Charts,   // a curve over its axes
    Limits,   // a frame with a mark in it
    Clients,  // two arrows in opposite directions
    Log,      // lines
    Mount,    // a dish on its mast
    North,    // a needle
    Question,
    Menu,  // three bars
    Screen,
    Language,
    Keys,
    Guide,
    Diagnostics,
    Profile,
    About,
    Brightness,
    Favourite,   // a star
    NoFavourite  // its outline
};

void drawGlyph(QPainter& painter, Glyph glyph, const QRectF& box, const QColor& colour);
[[nodiscard]] QIcon glyphIcon(Glyph glyph);
// A preview of a theme: its background, a line of text, the mark of a selection.
[[nodiscard]] QIcon themePicture(ThemeKind kind);

}  // namespace boresight::ui

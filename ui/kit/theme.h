// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

// All colours and fonts of the screen in one place. Grey is normal. Colour asks for attention, and always comes with a
// shape and a word. The text contrast is at least 4.5:1 (WCAG 2.1, checked by ThemeTest). Gui thread only: like
// QApplication's palette there is one current theme, and widgets read it while they paint.
namespace boresight::ui {

enum class ThemeKind
{
    Day,
    Night,
    Red  // night vision: red on black, so only shape and word show the status
};

// For the night and the red theme. By day the screen must be brighter than sunlight.
enum class Brightness
{
    High,
    Medium,
    Low
};

// The meaning of a text or a symbol. The theme turns it into a colour.
enum class Tone
{
    Normal,
    Secondary,
    Accent,
    Sensor,
    Advisory,
    Warning,
    Alarm
};

struct Theme
{
    ThemeKind kind = ThemeKind::Day;
    QColor window;      // background of the window
    QColor card;        // background of a group, on the window
    QColor plotGround;  // sky, lists and fields
    QColor band;        // sky below the lowest elevation
    QColor button;
    QColor text;
    QColor secondary;
    QColor grid;
    QColor hairline;  // the edge of a card, a button, a field
    QColor accent;
    QColor accentSoft;  // background of a chosen or pressed part
    QColor onAccent;    // words on the accent
    QColor sensor;      // the independent sensor
    QColor advisory;
    QColor warning;
    QColor alarm;
    QColor stop;  // the only area filled with red
    QColor stopText;
    QColor stopOutline;
    QColor skyZenith;  // the sky plot fades from the rim to this colour at the zenith
    QColor skyRim;
    QColor land;  // below the horizon
    QColor sun;

    [[nodiscard]] QColor colour(Tone tone) const;
    [[nodiscard]] QPalette palette() const;
};

[[nodiscard]] const Theme& theme(ThemeKind kind, Brightness brightness = Brightness::High);
[[nodiscard]] const Theme& currentTheme();
[[nodiscard]] Brightness currentBrightness();
[[nodiscard]] ThemeKind next(ThemeKind kind);
[[nodiscard]] QString name(ThemeKind kind);
[[nodiscard]] QString name(Brightness brightness);

// Makes the theme current and sets its palette in the application. Every widget repaints.
void applyTheme(ThemeKind kind, Brightness brightness);
void applyTheme(ThemeKind kind);  // with the present brightness

// The grid of the screen, and the least height of a row, a tab and a line of a menu, suitable for a finger.
inline constexpr int kGrid = 8;         // px
inline constexpr int kRowHeight = 32;   // px
inline constexpr double kRounding = 8;  // px, of a button or a card

// The sizes of ui.md, readable from two metres. Numbers have a fixed width, so that digits do not move. The window is
// laid out for lines of DejaVu. Fonts for many scripts have taller lines (Noto: 1.36 em instead of 1.16), and 1024×700
// has no room for them. Words become smaller until their line fits. Large numbers keep their size, because digits do
// not need the whole line.
namespace fonts {
[[nodiscard]] QFont label();             // 10 pt or smaller, interface font
[[nodiscard]] QFont text();              // 12 pt or smaller, interface font
[[nodiscard]] QFont state();             // 22 pt or smaller, interface font
[[nodiscard]] QFont actual(int points);  // fixed width
[[nodiscard]] QFont value();             // 16 pt, fixed width
[[nodiscard]] QFont clock();             // 14 pt, fixed width
[[nodiscard]] QFont small();             // 10 pt or smaller, fixed width

[[nodiscard]] int lineRoom(const QFont& font);      // px: the height of a DejaVu line with this size
[[nodiscard]] bool isOfNumbers(const QFont& font);  // actual(), value() or clock()
}  // namespace fonts

}  // namespace boresight::ui

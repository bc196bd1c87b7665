// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

// Every colour and every font of the screen, in one place. Grey is normal; colour says "look here" and always comes
// with a shape and a word. The values keep a text contrast of 4.5:1 (WCAG 2.1, checked by ThemeTest). Gui thread only:
// like QApplication's palette there is one current theme, and widgets read it while they paint.
namespace boresight::ui {

enum class ThemeKind
{
    Day,
    Night,
    Red  // night vision: red on black, shape and word carry the status alone
};

// Of the night and the red theme. By day the screen has to outshine the Sun.
enum class Brightness
{
    High,
    Medium,
    Low
};

// What a text or a symbol means; the theme turns it into a colour.
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
    QColor window;      // ground of the window
    QColor card;        // ground of what belongs together, on the window
    QColor plotGround;  // sky, lists and fields
    QColor band;        // sky below the lowest elevation
    QColor button;
    QColor text;
    QColor secondary;
    QColor grid;
    QColor hairline;  // the edge of a card, a button, a field
    QColor accent;
    QColor accentSoft;  // ground of what is chosen or held
    QColor onAccent;    // words on the accent
    QColor sensor;      // the independent sensor
    QColor advisory;
    QColor warning;
    QColor alarm;
    QColor stop;  // the only filled red area
    QColor stopText;
    QColor stopOutline;
    QColor skyZenith;  // of the sky plot, which fades from the rim to the zenith
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

// Makes the theme current and gives its palette to the application. Every widget repaints.
void applyTheme(ThemeKind kind, Brightness brightness);
void applyTheme(ThemeKind kind);  // with the brightness of now

// The grid of the screen, and the least height of a row, a tab and a line of a menu: a finger finds it.
inline constexpr int kGrid = 8;         // px
inline constexpr int kRowHeight = 32;   // px
inline constexpr double kRounding = 8;  // px, of a button or a card

// Sizes of ui.md: readable from two metres. Numbers are fixed-width, so that digits do not dance. The window is laid
// out for lines of DejaVu. Fonts for many scripts have taller lines (Noto: 1.36 em instead of 1.16), and 1024×700 has
// no room for them. Words get smaller until their line fits. Large numbers keep their size: digits do not need the
// whole line.
namespace fonts {
[[nodiscard]] QFont label();             // 10 pt or smaller, interface font
[[nodiscard]] QFont text();              // 12 pt or smaller, interface font
[[nodiscard]] QFont state();             // 22 pt or smaller, interface font
[[nodiscard]] QFont actual(int points);  // fixed width
[[nodiscard]] QFont value();             // 16 pt, fixed width
[[nodiscard]] QFont clock();             // 14 pt, fixed width
[[nodiscard]] QFont small();             // 10 pt or smaller, fixed width

[[nodiscard]] int lineRoom(const QFont& font);      // px: the line of DejaVu of this size
[[nodiscard]] bool isOfNumbers(const QFont& font);  // actual(), value() or clock()
}  // namespace fonts

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontMetrics>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace boresight::ui {

namespace {

// The colour table of ui.md. The alarm colour by day is slightly darker than STOP, which would have a contrast of
// 4.49:1.
const Theme kDay{.kind = ThemeKind::Day,
                 .window = QColor(0xe4e6e8),
                 .card = QColor(0xf7f8fa),
                 .plotGround = QColor(0xf4f5f6),
                 .band = QColor(0xd3d7db),
                 .button = QColor(0xffffff),
                 .text = QColor(0x1c2126),
                 .secondary = QColor(0x5b646d),
                 .grid = QColor(0xc3c9ce),
                 .hairline = QColor(0xb9c0c7),
                 .accent = QColor(0x1f4e79),
                 .accentSoft = QColor(0xcfdeed),
                 .onAccent = QColor(0xffffff),
                 .sensor = QColor(0x7a3e8e),
                 .advisory = QColor(0x00677a),
                 .warning = QColor(0x8f5200),
                 .alarm = QColor(0xc42727),
                 .stop = QColor(0xc62828),
                 .stopText = QColor(0xffffff),
                 .stopOutline = QColor(0x8a1c1c),
                 .skyZenith = QColor(0xfcfdfe),
                 .skyRim = QColor(0xdfe6f0),
                 .land = QColor(0xb9c1b4),
                 .sun = QColor(0xc98a00)};

const Theme kNight{.kind = ThemeKind::Night,
                   .window = QColor(0x1e2226),
                   .card = QColor(0x252a2f),
                   .plotGround = QColor(0x14171a),
                   .band = QColor(0x2a3036),
                   .button = QColor(0x2e343a),
                   .text = QColor(0xd6dade),
                   .secondary = QColor(0x8f99a3),
                   .grid = QColor(0x343b42),
                   .hairline = QColor(0x454d55),
                   .accent = QColor(0x9cc9f2),
                   .accentSoft = QColor(0x263a4d),
                   .onAccent = QColor(0x10161c),
                   .sensor = QColor(0xd7a6e8),
                   .advisory = QColor(0x5cc6d8),
                   .warning = QColor(0xffb84d),
                   .alarm = QColor(0xff5449),
                   .stop = QColor(0xc62828),
                   .stopText = QColor(0xffffff),
                   .stopOutline = QColor(0x7d1919),
                   .skyZenith = QColor(0x111315),
                   .skyRim = QColor(0x1a2938),
                   .land = QColor(0x2d332a),
                   .sun = QColor(0xffcf66)};

const Theme kRed{.kind = ThemeKind::Red,
                 .window = QColor(0x0a0000),
                 .card = QColor(0x120201),
                 .plotGround = QColor(Qt::black),
                 .band = QColor(0x260503),
                 .button = QColor(0x1a0302),
                 .text = QColor(0xff6a5a),
                 .secondary = QColor(0xdc5544),
                 .grid = QColor(0x4a1510),
                 .hairline = QColor(0x6b1f17),
                 .accent = QColor(0xff6a5a),
                 .accentSoft = QColor(0x3d0a06),
                 .onAccent = QColor(0x0a0000),
                 .sensor = QColor(0xff6a5a),
                 .advisory = QColor(0xff6a5a),
                 .warning = QColor(0xff6a5a),
                 .alarm = QColor(0xff6a5a),
                 .stop = QColor(0x6e0c0a),
                 .stopText = QColor(0xffc2b8),
                 .stopOutline = QColor(0xff8070),
                 .skyZenith = QColor(Qt::black),
                 .skyRim = QColor(0x140201),
                 .land = QColor(0x2c0805),
                 .sun = QColor(0xff6a5a)};

ThemeKind g_current = ThemeKind::Day;
Brightness g_brightness = Brightness::High;

constexpr std::size_t kBrightnesses = 3;

QColor scaled(const QColor& colour, double factor)
{
    return QColor::fromRgbF(static_cast<float>(colour.redF() * factor), static_cast<float>(colour.greenF() * factor),
                            static_cast<float>(colour.blueF() * factor));
}

// Backgrounds are dimmed more than words, so that text keeps its contrast. Warnings and alarms keep their brightness.
Theme dimmed(Theme theme, double grounds, double words)
{
    for (QColor* const ground :
         {&theme.window, &theme.card, &theme.plotGround, &theme.band, &theme.button, &theme.grid, &theme.hairline,
          &theme.accentSoft, &theme.onAccent, &theme.stop, &theme.skyZenith, &theme.skyRim, &theme.land}) {
        *ground = scaled(*ground, grounds);
    }
    for (QColor* const word : {&theme.text, &theme.secondary, &theme.accent, &theme.sensor, &theme.advisory,
                               &theme.stopText, &theme.stopOutline, &theme.sun}) {
        *word = scaled(*word, words);
    }
    return theme;
}

using Steps = std::array<Theme, kBrightnesses>;

// The height of a line of DejaVu above and below its base line, from its table hhea.
constexpr double kAscent = 1901.0 / 2048.0;  // em
constexpr double kDescent = 483.0 / 2048.0;
constexpr int kSmallest = 6;         // px
constexpr int kSmallestNumber = 14;  // pt

QFont sized(QFont font, int points)
{
    font.setPointSize(points);
    return font;
}

// FreeType measures in 64ths of a pixel, Qt in whole pixels.
int rounded(double pixels)
{
    return static_cast<int>(std::lround(std::round(pixels * 64.0) / 64.0));
}

int pixelsOf(const QFont& font)
{
    return static_cast<int>(std::lround(font.pointSizeF() * QFontMetrics(font).fontDpi() / 72.0));
}

// Reduces the font until its line fits into its room.
QFont shrunk(const QFont& wanted)
{
    const int room = fonts::lineRoom(wanted);
    QFont font = wanted;
    for (int pixels = pixelsOf(wanted); pixels > kSmallest && QFontMetrics(font).lineSpacing() > room; --pixels) {
        font.setPointSizeF(72.0 * (pixels - 1) / QFontMetrics(wanted).fontDpi());
    }
    return font;
}

// Cached, because painting needs it many times a second.
QFont fitted(const QFont& font, int points)
{
    static std::map<std::pair<QFont, int>, QFont> known;
    const auto [found, isNew] = known.try_emplace({font, points});
    if (isNew) {
        found->second = shrunk(sized(font, points));
    }
    return found->second;
}

QFont fixedWidth()
{
    return QFontDatabase::systemFont(QFontDatabase::FixedFont);
}

}  // namespace

QColor Theme::colour(Tone tone) const
{
    switch (tone) {
        case Tone::Normal:
            return text;
        case Tone::Secondary:
            return secondary;
        case Tone::Accent:
            return accent;
        case Tone::Sensor:
            return sensor;
        case Tone::Advisory:
            return advisory;
        case Tone::Warning:
            return warning;
        case Tone::Alarm:
            return alarm;
    }
    return text;
}

QPalette Theme::palette() const
{
    QPalette palette(button, window);  // adds Fusion's light, mid and dark shades
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, kind == ThemeKind::Day ? button : plotGround);  // for fields and lists
    palette.setColor(QPalette::AlternateBase, card);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::BrightText, text);
    palette.setColor(QPalette::PlaceholderText, secondary);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, onAccent);
    palette.setColor(QPalette::ToolTipBase, plotGround);
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::Link, accent);
    const auto fade = [](int of, int into) { return (7 * of + 3 * into) / 10; };
    const QColor faded(fade(text.red(), window.red()), fade(text.green(), window.green()),
                       fade(text.blue(), window.blue()));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, faded);
    }
    return palette;
}

const Theme& theme(ThemeKind kind, Brightness brightness)
{
    static const Steps night{kNight, dimmed(kNight, 0.65, 0.9), dimmed(kNight, 0.35, 0.82)};
    static const Steps red{kRed, dimmed(kRed, 0.75, 0.96), dimmed(kRed, 0.5, 0.93)};
    switch (kind) {
        case ThemeKind::Night:
            return night.at(static_cast<std::size_t>(brightness));
        case ThemeKind::Red:
            return red.at(static_cast<std::size_t>(brightness));
        case ThemeKind::Day:
            break;
    }
    return kDay;
}

const Theme& currentTheme()
{
    return theme(g_current, g_brightness);
}

Brightness currentBrightness()
{
    return g_brightness;
}

ThemeKind next(ThemeKind kind)
{
    switch (kind) {
        case ThemeKind::Day:
            return ThemeKind::Night;
        case ThemeKind::Night:
            return ThemeKind::Red;
        case ThemeKind::Red:
            break;
    }
    return ThemeKind::Day;
}

QString name(ThemeKind kind)
{
    switch (kind) {
        case ThemeKind::Night:
            return QApplication::translate("Theme", "Night");
        case ThemeKind::Red:
            return QApplication::translate("Theme", "Red");
        case ThemeKind::Day:
            break;
    }
    return QApplication::translate("Theme", "Day");
}

QString name(Brightness brightness)
{
    switch (brightness) {
        case Brightness::Medium:
            return QApplication::translate("Theme", "Medium");
        case Brightness::Low:
            return QApplication::translate("Theme", "Low");
        case Brightness::High:
            break;
    }
    return QApplication::translate("Theme", "High");
}

void applyTheme(ThemeKind kind, Brightness brightness)
{
    g_current = kind;
    g_brightness = brightness;
    QApplication::setPalette(currentTheme().palette());
}

void applyTheme(ThemeKind kind)
{
    applyTheme(kind, g_brightness);
}

namespace fonts {

int lineRoom(const QFont& font)
{
    const int pixels = pixelsOf(font);
    return rounded(kAscent * pixels) + rounded(kDescent * pixels);
}

QFont label()
{
    return fitted(QApplication::font(), 10);
}

QFont text()
{
    return fitted(QApplication::font(), 12);
}

QFont state()
{
    return fitted(QApplication::font(), 22);
}

QFont actual(int points)
{
    return sized(fixedWidth(), points);
}

QFont value()
{
    return sized(fixedWidth(), 16);
}

QFont clock()
{
    return sized(fixedWidth(), kSmallestNumber);
}

bool isOfNumbers(const QFont& font)
{
    return font.family() == fixedWidth().family() && font.pointSize() >= kSmallestNumber;
}

QFont small()
{
    return fitted(fixedWidth(), 10);
}

}  // namespace fonts

}  // namespace boresight::ui

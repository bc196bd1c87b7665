// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme.h"

#include <QApplication>
#include <QFontMetrics>

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::ui {
namespace {

// Relative luminance and contrast ratio of WCAG 2.1.
double linear(double channel)
{
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour)
{
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double bright = std::max(luminance(a), luminance(b));
    const double dark = std::min(luminance(a), luminance(b));
    return (bright + 0.05) / (dark + 0.05);
}

struct Look
{
    ThemeKind kind;
    Brightness brightness;
};

class ThemeTest : public ::testing::TestWithParam<Look>
{
protected:
    static const Theme& colours() { return theme(GetParam().kind, GetParam().brightness); }
};

TEST(Contrast, OfBlackAndWhiteIs21)
{
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-6);
}

// REQ-UI-10 (ThemeTest.*): Text contrast is 4.5:1 or better in every theme.
TEST_P(ThemeTest, EveryToneIsReadableOnTheGroundsItIsWrittenOn)
{
    const Theme& colours = ThemeTest::colours();
    for (const Tone tone : {Tone::Normal, Tone::Secondary, Tone::Accent, Tone::Advisory, Tone::Warning, Tone::Alarm}) {
        for (const QColor& ground : {colours.window, colours.card, colours.plotGround}) {
            EXPECT_GE(contrast(colours.colour(tone), ground), 4.5)
                << colours.colour(tone).name().toStdString() << " on " << ground.name().toStdString();
        }
    }
    EXPECT_GE(contrast(colours.stopText, colours.stop), 4.5);
    EXPECT_GE(contrast(colours.onAccent, colours.accent), 4.5);
    EXPECT_GE(contrast(colours.text, colours.accentSoft), 4.5);
    EXPECT_GE(contrast(colours.accent, colours.button), 4.5);
    EXPECT_GE(contrast(colours.text, colours.band), 4.5);  // names of the sectors that are out of reach
}

TEST_P(ThemeTest, EveryPairOfThePaletteIsReadable)
{
    const QPalette palette = colours().palette();
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
        {QPalette::WindowText, QPalette::Window},    {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},   {QPalette::ButtonText, QPalette::Button},
        {QPalette::ButtonText, QPalette::Light},     {QPalette::ToolTipText, QPalette::ToolTipBase},
        {QPalette::PlaceholderText, QPalette::Base}, {QPalette::HighlightedText, QPalette::Highlight}};
    for (const auto& [text, ground] : pairs) {
        EXPECT_GE(contrast(palette.color(text), palette.color(ground)), 4.5) << int(text) << " on " << int(ground);
    }
    // Disabled words may have less contrast, but must be legible (3:1, the limit of WCAG for large text).
    EXPECT_GE(contrast(palette.color(QPalette::Disabled, QPalette::ButtonText), palette.color(QPalette::Button)), 3.0);
}

INSTANTIATE_TEST_SUITE_P(
    All, ThemeTest,
    ::testing::Values(Look{ThemeKind::Day, Brightness::High}, Look{ThemeKind::Night, Brightness::High},
                      Look{ThemeKind::Night, Brightness::Medium}, Look{ThemeKind::Night, Brightness::Low},
                      Look{ThemeKind::Red, Brightness::High}, Look{ThemeKind::Red, Brightness::Medium},
                      Look{ThemeKind::Red, Brightness::Low}));

// REQ-UI-901: The night and the red theme have three steps of brightness. Warnings and alarms keep their brightness.
TEST(Brightness, EachStepIsDarkerThanTheOneBefore)
{
    for (const ThemeKind kind : {ThemeKind::Night, ThemeKind::Red}) {
        const Theme& high = theme(kind, Brightness::High);
        const Theme& medium = theme(kind, Brightness::Medium);
        const Theme& low = theme(kind, Brightness::Low);
        EXPECT_GT(luminance(high.text), luminance(medium.text));
        EXPECT_GT(luminance(medium.text), luminance(low.text));
        EXPECT_GT(luminance(high.button), luminance(medium.button));
        EXPECT_GT(luminance(medium.button), luminance(low.button));
        EXPECT_EQ(high.alarm, low.alarm);
    }
}

// REQ-UI-902: In the red theme STOP is dark red with a bright outline.
TEST(Brightness, InTheRedThemeStopIsDarkWithABrightOutline)
{
    for (const Brightness step : {Brightness::High, Brightness::Medium, Brightness::Low}) {
        const Theme& red = theme(ThemeKind::Red, step);
        EXPECT_LT(luminance(red.stop), 0.05);
        EXPECT_GE(contrast(red.stopOutline, red.stop), 4.5);
        EXPECT_GE(contrast(red.stopOutline, red.window), 4.5);
    }
}

// The layout is made for DejaVu, so it has room for DejaVu in every size.
TEST(Fonts, OfDejaVuHaveTheirLine)
{
    for (int points = 6; points <= 40; ++points) {
        const QFont font(QStringLiteral("DejaVu Sans"), points);
        EXPECT_EQ(fonts::lineRoom(font), QFontMetrics(font).height()) << points;
    }
}

TEST(Fonts, OfWordsHaveNoMoreThanTheirLine)
{
    const std::pair<QFont, int> sizes[] = {
        {fonts::label(), 10}, {fonts::text(), 12}, {fonts::state(), 22}, {fonts::small(), 10}};
    for (const auto& [font, points] : sizes) {
        const QFont asked(font.family(), points);
        EXPECT_LE(QFontMetrics(font).lineSpacing(), fonts::lineRoom(asked)) << points;
        EXPECT_LE(font.pointSizeF(), points);
        EXPECT_GE(font.pointSizeF(), 0.75 * points) << "readable";
    }
}

TEST(Theme, NextGoesRound)
{
    EXPECT_EQ(next(next(next(ThemeKind::Day))), ThemeKind::Day);
    EXPECT_NE(next(ThemeKind::Day), next(ThemeKind::Night));
}

}  // namespace
}  // namespace boresight::ui

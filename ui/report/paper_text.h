// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

#include <array>
#include <cstddef>

// Colours, pens and texts of a printed report: black on white, whatever theme the window has. The unit of all lengths
// is 0.1 mm on paper. Any thread with a QGuiApplication.
namespace boresight::ui {

inline constexpr QColor kInk{28, 33, 38};
inline constexpr QColor kFaintInk{91, 100, 109};
inline constexpr QColor kPaperGrid{195, 201, 206};
inline constexpr QColor kPlanInk{110, 110, 110};
inline constexpr QColor kTargetInk{150, 150, 150};
inline constexpr QColor kBoundInk{176, 36, 24};
// The first and the second pass. Both differ in lightness, too, so they differ on a black and white print.
inline constexpr std::array<QColor, 2> kPassInk{QColor(31, 78, 121), QColor(214, 120, 20)};

inline constexpr int kSmallLetters = 26;  // 2.6 mm
inline constexpr int kTableLetters = 29;
inline constexpr int kTitleLetters = 56;

[[nodiscard]] QFont paperFont(int size, bool isBold = false);
[[nodiscard]] QPen paperPen(const QColor& colour, qreal width, Qt::PenStyle style = Qt::SolidLine);

// Draws one line of text inside of `room`. A text that is too wide gets smaller letters, to two thirds. A text that is
// still too wide is cut, with "…".
struct PaperText
{
    QString text;
    int size = kTableLetters;
    QColor colour = kInk;
    bool isBold = false;
    Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter;
};
void drawPaperText(QPainter& painter, const QRectF& room, const PaperText& text);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/value_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {
constexpr int kValueLabelMargin = 2;  // px, so that a slanted character is not cut off
constexpr int kOutline = 5;           // px around the text of an outlined tag
constexpr int kLongWord = 24;         // characters: a longer word may be wider than a narrow label

// Allows line breaks in long words. The path of a device is one word as long as three.
QString withBreaks(const QString& text)
{
    QString broken;
    qsizetype inWord = 0;
    qsizetype length = 0;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (inWord == 0) {
            const qsizetype end = text.indexOf(QLatin1Char(' '), i);
            length = (end < 0 ? text.size() : end) - i;
        }
        broken += text[i];
        inWord = text[i] == QLatin1Char(' ') ? 0 : inWord + 1;
        if (length > kLongWord && text[i].isPunct()) {
            broken += QChar(0x200b);  // a line may end here
        }
    }
    return broken;
}

// The whole sentences of a line that are within the width. If even the first one is wider: its part before a colon, if
// that says enough.
QString sentencesWithin(const QString& line, int width, const QFontMetrics& metrics)
{
    QString sentences;
    QString clause;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        if (line[i + 1] != QLatin1Char(' ') || metrics.horizontalAdvance(line.left(i + 1)) > width) {
            continue;
        }
        if (QStringLiteral(".?!").contains(line[i])) {
            sentences = line.left(i + 1);
        } else if (line[i] == QLatin1Char(':')) {
            clause = line.left(i);
        }
    }
    const bool isTooLittle = metrics.horizontalAdvance(clause) < width / 2;
    return !sentences.isEmpty() ? sentences : isTooLittle ? QString() : clause;
}
}  // namespace

ValueLabel::ValueLabel(const QString& accessibleName, const QFont& font, const QString& widestText, QWidget* parent)
    : QWidget(parent), m_widest(widestText)
{
    setAccessibleName(accessibleName);
    setFont(font);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ValueLabel::setAlignment(Qt::Alignment alignment)
{
    m_alignment = alignment;
}

void ValueLabel::setLines(int lines)
{
    if (lines != m_lines) {
        m_lines = lines;
        updateGeometry();
    }
}

void ValueLabel::setWrapping(bool on)
{
    m_wrapping = on;
    setSizePolicy(on ? QSizePolicy::Expanding : QSizePolicy::Fixed, QSizePolicy::Preferred);
    updateGeometry();
}

void ValueLabel::setStretching(bool on)
{
    m_stretching = on;
    setSizePolicy(on ? QSizePolicy::Expanding : QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ValueLabel::setWidest(const QString& text)
{
    if (text != m_widest) {
        m_widest = text;
        updateGeometry();
    }
}

void ValueLabel::setBySentences(bool on)
{
    m_bySentences = on;
    update();
}

void ValueLabel::setOutlined(bool on)
{
    m_outlined = on;
}

void ValueLabel::setSymbolRoom(bool on)
{
    m_symbolRoom = on;
}

void ValueLabel::setCollapsing(bool on)
{
    m_collapsing = on;
    setVisible(!on || !m_text.isEmpty());
}

void ValueLabel::setValue(const QString& text, Tone tone, Symbol symbol)
{
    if (text == m_text && tone == m_tone && symbol == m_symbol) {
        return;
    }
    const bool otherHeight = m_wrapping && text != m_text;
    m_text = text;
    m_tone = tone;
    m_symbol = symbol;
    setAccessibleDescription(text);
    if (otherHeight) {
        updateGeometry();
    }
    if (m_collapsing) {
        setVisible(!text.isEmpty());
    }
    update();
}

double ValueLabel::symbolSize() const
{
    return fontMetrics().ascent() * 0.8;
}

int ValueLabel::symbolRoom() const
{
    return static_cast<int>(std::ceil(symbolSize() * 1.5));
}

// The line spacing of wrapped text is slightly larger than lineSpacing().
int ValueLabel::linesHeight() const
{
    const QString lines = QStringLiteral("X\n").repeated(m_lines - 1) + QLatin1Char('X');
    return fontMetrics().boundingRect(QRect(0, 0, QWIDGETSIZE_MAX, QWIDGETSIZE_MAX), Qt::TextWordWrap, lines).height();
}

// Numbers keep their size, because they need no room for accents and descenders. Words become smaller where their lines
// are taller.
int ValueLabel::excess() const
{
    return wraps() || !fonts::isOfNumbers(font()) ? 0 : std::max(0, fontMetrics().height() - fonts::lineRoom(font()));
}

QSize ValueLabel::sizeHint() const
{
    const int extra = 2 * (m_outlined ? kOutline : kValueLabelMargin) + 2 +  // advances are rounded
                      (m_symbolRoom ? symbolRoom() : 0);
    return {fontMetrics().horizontalAdvance(m_widest) + extra, linesHeight() - excess() + (m_outlined ? 4 : 0)};
}

QSize ValueLabel::minimumSizeHint() const
{
    return {m_stretching || m_wrapping ? 0 : sizeHint().width(), sizeHint().height()};
}

int ValueLabel::heightForWidth(int width) const
{
    return m_wrapping ? heightWith(m_text, width) : -1;
}

int ValueLabel::heightWith(const QString& text, int width) const
{
    return heightOf(withBreaks(text), width - aroundText());
}

QString ValueLabel::shownText() const
{
    return m_wrapping ? withBreaks(m_text) : m_text;
}

int ValueLabel::aroundText() const
{
    return 2 * (m_outlined ? kOutline : kValueLabelMargin) + (m_symbol == Symbol::None ? 0 : symbolRoom());
}

int ValueLabel::heightOf(const QString& text, int width) const
{
    // Without the alignment, because centring in such a high rectangle would round the height up.
    return fontMetrics().boundingRect(QRect(0, 0, width, QWIDGETSIZE_MAX), Qt::TextWordWrap, text).height();
}

QRect ValueLabel::textRect() const
{
    const int margin = m_outlined ? kOutline : kValueLabelMargin;
    return rect().adjusted(margin + (m_symbol == Symbol::None ? 0 : symbolRoom()), 0, -margin, 0);
}

// The part of the text that fits. The complete text is in the tooltip.
QString ValueLabel::fitted(QSize room) const
{
    if (!wraps()) {
        const QString elided = fontMetrics().elidedText(m_text, Qt::ElideRight, room.width());
        const QString whole =
            m_bySentences && elided != m_text ? sentencesWithin(m_text, room.width(), fontMetrics()) : QString();
        return whole.isEmpty() ? elided : whole;
    }
    const auto fits = [&](const QString& text) {
        return heightOf(text, room.width()) <= std::max(room.height(), linesHeight());
    };
    const QString text = shownText();
    if (fits(text)) {
        return text;
    }
    qsizetype least = 0;
    for (qsizetype most = text.size(); most - least > 1;) {
        const qsizetype middle = (least + most) / 2;
        (fits(text.left(middle) + QStringLiteral("…")) ? least : most) = middle;
    }
    return text.left(least) + QStringLiteral("…");
}

void ValueLabel::paintEvent(QPaintEvent*)
{
    if (m_text.isEmpty()) {
        return;
    }
    QPainter painter(this);
    const QColor colour = currentTheme().colour(m_tone);
    const QRect room = textRect();
    const int flags = int(m_alignment) | (wraps() ? int(Qt::TextWordWrap) : int(Qt::TextSingleLine));
    const QString shown = visibleText();
    if (m_symbol != Symbol::None) {
        const QRect used = fontMetrics().boundingRect(room, flags, shown);
        const double size = symbolSize();
        const double top =
            wraps() ? used.top() + 0.5 * (fontMetrics().height() - size) : room.center().y() + 0.5 - 0.5 * size;
        drawSymbol(painter, m_symbol, QRectF(used.left() - symbolRoom(), top, size, size), colour);
    }
    painter.setPen(colour);
    painter.drawText(room, excess() > 0 ? flags | Qt::TextDontClip : flags, shown);
    if (m_outlined) {
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

bool ValueLabel::isElided() const
{
    return wraps() ? heightOf(shownText(), textRect().width()) > height()
                   : fontMetrics().horizontalAdvance(m_text) > textRect().width();
}

bool ValueLabel::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && toolTip().isEmpty() && isElided()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), m_text, this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace boresight::ui

#include "moc_value_label.cpp"

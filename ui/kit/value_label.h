// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <QWidget>

// A text that changes twenty times a second. Its size is always that of its template. So a new text repaints only this
// widget, and the layout never moves. (A QLabel would lay out the whole window again.) An optional symbol precedes the
// text. A text that does not fit is elided, and the tooltip shows it completely.
namespace boresight::ui {

class ValueLabel : public QWidget
{
    Q_OBJECT

public:
    ValueLabel(const QString& accessibleName, const QFont& font, const QString& widestText, QWidget* parent = nullptr);

    void setAlignment(Qt::Alignment alignment);
    void setLines(int lines);     // more than one: words wrap
    void setWrapping(bool on);    // words wrap, and the height follows from the text and the given width
    void setStretching(bool on);  // takes the given width instead of that of the template
    void setOutlined(bool on);
    void setBySentences(bool on);         // a line that is too long is shown up to the end of a sentence, or to a colon
    void setWidest(const QString& text);  // sets another template
    void setSymbolRoom(bool on);          // the template's width gets room for a symbol
    void setCollapsing(bool on);          // takes no room while it is empty

    void setValue(const QString& text, Tone tone = Tone::Normal, Symbol symbol = Symbol::None);

    [[nodiscard]] const QString& text() const { return m_text; }
    [[nodiscard]] bool isElided() const;  // the text does not fit
    [[nodiscard]] QString visibleText() const { return fitted(textRect().size()); }
    [[nodiscard]] Tone tone() const { return m_tone; }
    [[nodiscard]] Symbol symbol() const { return m_symbol; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return m_wrapping; }
    [[nodiscard]] int heightForWidth(int width) const override;
    // the height of a wrapping label with this text
    [[nodiscard]] int heightWith(const QString& text, int width) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRect textRect() const;
    [[nodiscard]] bool wraps() const { return m_wrapping || m_lines > 1; }
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] int aroundText() const;  // px of the width that are not available for the text
    [[nodiscard]] int heightOf(const QString& text, int width) const;
    [[nodiscard]] QString fitted(QSize room) const;
    [[nodiscard]] double symbolSize() const;
    [[nodiscard]] int linesHeight() const;
    [[nodiscard]] int excess() const;      // px by which a line is taller than in the layout
    [[nodiscard]] int symbolRoom() const;  // the symbol and the gap after it

    QString m_text;
    QString m_widest;
    Tone m_tone = Tone::Normal;
    Symbol m_symbol = Symbol::None;
    Qt::Alignment m_alignment = Qt::AlignLeft | Qt::AlignVCenter;
    int m_lines = 1;
    bool m_stretching = false;
    bool m_wrapping = false;
    bool m_outlined = false;
    bool m_bySentences = false;
    bool m_collapsing = false;
    bool m_symbolRoom = false;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;

// A question or an offer that lies over a corner of the plot, never over STOP, and blocks nothing: a text and a few
// buttons. Hidden until shown.
namespace boresight::ui {

class ValueLabel;

class PromptBar : public QFrame
{
    Q_OBJECT

public:
    // `widest`: the longest text; a shorter one has its room.
    PromptBar(const QString& accessibleName, QWidget* parent,
              const QString& widest = QStringLiteral("Stopping and closing …"));

    void addButton(QWidget& button);
    void setText(const QString& text);
    void setLines(int lines);  // of the text

    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

private:
    ValueLabel* m_text;
    ValueLabel* m_notice;
    QHBoxLayout* m_buttons;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;

// A question or an offer that lies over a corner of the plot, never over STOP, and blocks nothing: a text and a few
// buttons. Hidden until shown.
namespace boresight::ui {

class ValueLabel;

class PromptBar : public QFrame
{
    Q_OBJECT

public:
    // `texts`: the longest that it will say. It is as wide as the widest of them needs in so many lines, once and for
    // all.
    PromptBar(const QString& accessibleName, const QStringList& texts, int lines, QWidget* parent);

    void addButton(QWidget& button);
    QPushButton* addButton(const QString& text);
    void setText(const QString& text);
    void dismiss();  // presses the last button, which declines

    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

private:
    ValueLabel* m_text;
    ValueLabel* m_notice;
    QHBoxLayout* m_buttons;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;

// A question or an offer over a corner of the plot, never over STOP. It blocks nothing. It has a text and a few
// buttons, and is hidden until shown.
namespace boresight::ui {

class ValueLabel;

class PromptBar : public QFrame
{
    Q_OBJECT

public:
    // `texts` are the longest texts that it will show. It always has the width that the widest of them needs in this
    // number of lines.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/leavable.h"

#include <QFrame>

class QHBoxLayout;
class QPushButton;

// A question or an offer over a corner of the plot, never over STOP. It blocks nothing. It has a text and a few
// buttons, and is hidden until shown.
namespace boresight::ui {

class ValueLabel;

class PromptBar : public QFrame, public Leavable
{
    Q_OBJECT

public:
    // `texts` are the longest texts that it will show. It always has the width that the widest of them needs in this
    // number of lines.
    PromptBar(const QString& accessibleName, const QStringList& texts, int lines, QWidget* parent);

    void addButton(QWidget& button);
    QPushButton* addButton(const QString& text);
    void setText(const QString& text);
    bool leave() override;  // presses the last button, which declines
    void takeFocus();       // on that button, so that Esc and Space decline

    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QPushButton* declining() const;

    ValueLabel* m_text;
    ValueLabel* m_notice;
    QHBoxLayout* m_buttons;
};

}  // namespace boresight::ui

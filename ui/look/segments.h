// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;

// Exclusive choices, side by side within one edge.
namespace boresight::ui {

class ChoiceButton;

class Segments : public QWidget
{
    Q_OBJECT

public:
    explicit Segments(QWidget* parent = nullptr);

    void add(ChoiceButton& choice);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QHBoxLayout* m_row;
};

}  // namespace boresight::ui

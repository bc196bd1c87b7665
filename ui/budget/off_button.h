// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

// The frame around the error of the mount: a press opens the error budget. The words below it are labels of their own.
// Gui thread.
namespace boresight::ui {

class OffButton : public QToolButton
{
    Q_OBJECT

public:
    explicit OffButton(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace boresight::ui

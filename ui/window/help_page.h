// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

// One page with every key of the window. Not modal, so that STOP stays in reach.
namespace boresight::ui {

class HelpPage : public QDialog
{
    Q_OBJECT

public:
    explicit HelpPage(QWidget* parent = nullptr);
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

// Version, licence and libraries of this program. Not modal, so that STOP stays in reach.
namespace boresight::ui {

class AboutPage : public QDialog
{
    Q_OBJECT

public:
    explicit AboutPage(QWidget* parent = nullptr);
};

}  // namespace boresight::ui

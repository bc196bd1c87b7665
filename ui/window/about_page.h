// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

// What this program is: version, licence, libraries. Not modal: STOP stays in reach.
namespace boresight::ui {

class AboutPage : public QDialog
{
    Q_OBJECT

public:
    explicit AboutPage(QWidget* parent = nullptr);
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

// One page with every key and every mark of the screen, and the choice of the language. Not modal: STOP stays in
// reach.
namespace boresight::ui {

class HelpPage : public QDialog
{
    Q_OBJECT

public:
    // `language` is the one chosen now (ui/language.h).
    explicit HelpPage(const QString& language, QWidget* parent = nullptr);

Q_SIGNALS:
    void languageChosen(const QString& language);

private:
    QLayout* languageRow(const QString& chosen);
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

// Buttons without a request to the station. (Those with a request are CommandButtons.) Small font, large enough for a
// gloved finger.
namespace boresight::ui {

struct ButtonWords
{
    QString text;
    QString name;  // for a screen reader; empty: the text is the name
    QString help;
};

[[nodiscard]] QPushButton* makePushButton(const ButtonWords& words, QWidget* parent);

}  // namespace boresight::ui

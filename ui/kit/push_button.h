// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

// The buttons that ask nothing of the station; those that do are CommandButtons. Small font, for a gloved finger.
namespace boresight::ui {

struct ButtonWords
{
    QString text;
    QString name;  // for a screen reader; empty: the text says it
    QString help;
};

[[nodiscard]] QPushButton* makePushButton(const ButtonWords& words, QWidget* parent);

}  // namespace boresight::ui

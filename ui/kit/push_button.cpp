// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/push_button.h"

#include "ui/kit/command_button.h"
#include "ui/kit/theme.h"

namespace boresight::ui {

QPushButton* makePushButton(const ButtonWords& words, QWidget* parent)
{
    auto* const button = new QPushButton(words.text, parent);
    button->setFont(fonts::label());
    button->setAutoDefault(false);
    button->setAccessibleName(words.name.isEmpty() ? words.text : words.name);
    button->setToolTip(words.help);
    button->setMinimumHeight(kTouchSize);
    return button;
}

}  // namespace boresight::ui

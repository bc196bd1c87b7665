// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

// The words above or in front of what they name.
namespace boresight::ui {

[[nodiscard]] QLabel* makeCaption(const QString& text, QWidget* parent);
[[nodiscard]] QLabel* makeCaption(const QString& text, QWidget& field);  // becomes the caption of the field

// In small capitals, above a group.
[[nodiscard]] QLabel* makeGroupCaption(const QString& text, QWidget* parent);

}  // namespace boresight::ui

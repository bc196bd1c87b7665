// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

// The words above, or in front of, what they name.
namespace boresight::ui {

[[nodiscard]] QLabel* makeCaption(const QString& text, QWidget* parent);
[[nodiscard]] QLabel* makeCaption(const QString& text, QWidget& field);  // its buddy, and where it is

// Above what belongs together, in small capitals.
[[nodiscard]] QLabel* makeGroupCaption(const QString& text, QWidget* parent);

}  // namespace boresight::ui

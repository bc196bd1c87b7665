// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

// The text that needs the most room, so that a layout fits all of them in every language. Pure.
namespace boresight::ui {

[[nodiscard]] QString widest(const QFont& font, const QStringList& texts);
// The narrowest line width at which each of the texts, wrapped, needs at most this number of lines.
[[nodiscard]] QString widestLine(const QFont& font, const QStringList& texts, int lines);
[[nodiscard]] QString widestStationState(const QFont& font);
[[nodiscard]] QString widestAxisState(const QFont& font);

}  // namespace boresight::ui

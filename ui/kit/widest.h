// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

// Of several texts the one that needs the most room, so that a layout holds all of them in every language. Pure.
namespace boresight::ui {

[[nodiscard]] QString widest(const QFont& font, const QStringList& texts);
// The narrowest line with which each of the texts, its words wrapped, needs no more than so many lines.
[[nodiscard]] QString widestLine(const QFont& font, const QStringList& texts, int lines);
[[nodiscard]] QString widestStationState(const QFont& font);
[[nodiscard]] QString widestAxisState(const QFont& font);

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>

#include <string_view>

// What the readers of all formats ask of an element set. Pure.
namespace boresight::orbit {

// Why a set of readable numbers is no orbit, else empty.
[[nodiscard]] QString elementProblem(const ElementSet& elements);

// A text of a file as a message quotes it: printable, and not longer than a line of a message.
[[nodiscard]] QString quoted(std::string_view text);

}  // namespace boresight::orbit

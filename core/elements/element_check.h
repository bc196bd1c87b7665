// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>

#include <cstddef>
#include <string>
#include <string_view>

// What the readers of all formats ask of an element set. Pure.
namespace boresight::orbit {

// Why a set of readable numbers is no orbit, else empty.
[[nodiscard]] QString elementProblem(const ElementSet& elements);

// A text of a file as a message quotes it: printable, and not longer than a line of a message.
[[nodiscard]] QString quoted(std::string_view text, std::size_t longest = 40);

// A name or a designator of a file as a set keeps it: printable UTF-8 of a length that a list can show.
[[nodiscard]] std::string nameOf(std::string_view text);

// The first letter of a classification. Another text is 'U', unclassified.
[[nodiscard]] char classificationOf(std::string_view text);

}  // namespace boresight::orbit

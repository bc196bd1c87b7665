// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"

#include <QString>

#include <cstddef>
#include <string>
#include <string_view>

// The checks that the readers of all formats share. Pure.
namespace boresight::orbit {

// Why these numbers are not a valid orbit. Empty: the orbit is valid.
[[nodiscard]] QString elementProblem(const ElementSet& elements);

// A text from a file as a message quotes it: printable, and shortened to fit into a message.
[[nodiscard]] QString quoted(std::string_view text, std::size_t longest = 40);

// A name or designator from a file: made printable UTF-8 of a length that a list can show.
[[nodiscard]] std::string nameOf(std::string_view text);

// The first letter of the classification. Any other text is 'U', unclassified.
[[nodiscard]] char classificationOf(std::string_view text);

}  // namespace boresight::orbit

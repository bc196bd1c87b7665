// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/text_of.h"

namespace boresight::response {

// The reason why there are no figures. Empty if there are figures.
template <class Figures>
[[nodiscard]] std::string reasonOf(const Result<Figures>& figures)
{
    return figures ? std::string() : textOf(figures.error());
}

}  // namespace boresight::response

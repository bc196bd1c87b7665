// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/grammar.h"

namespace boresight::fuzz {

// What servers answer when they are asked for element sets: status, headers and content.
[[nodiscard]] Grammar answerGrammar();

}  // namespace boresight::fuzz

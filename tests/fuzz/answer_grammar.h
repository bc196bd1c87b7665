// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/grammar.h"

namespace boresight::fuzz {

// The answers of servers to a request for element sets: status, headers and content.
[[nodiscard]] Grammar answerGrammar();

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/grammar.h"

#include <cstdint>
#include <span>
#include <string_view>

// A randomised test of one kind of input: the form of valid inputs, and a function that gives any bytes to the real
// entry point and checks its promises. One harness for each program. main.cpp or libFuzzer drives it.
namespace boresight::fuzz {

// Defined by each harness.
[[nodiscard]] Grammar grammar();
void feed(std::span<const std::uint8_t> input);

// For the harness (harness.cpp).
void require(bool holds, std::string_view promise);  // aborts with the promise if it is broken
void accept();                                       // the whole input was accepted as valid

// For the driver: whether accept() was called since the last call.
[[nodiscard]] bool takeAccepted();

[[nodiscard]] std::string_view asText(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::span<const std::uint8_t> asBytes(std::string_view text);

}  // namespace boresight::fuzz

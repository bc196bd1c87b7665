// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/grammar.h"

#include <cstdint>
#include <span>
#include <string_view>

// What a randomised test of one input consists of: what valid inputs look like, and one function that gives any bytes
// to the real entry point and holds it to its promises. One harness per program; main.cpp or libFuzzer drives it.
namespace boresight::fuzz {

// Defined by each harness.
[[nodiscard]] Grammar grammar();
void feed(std::span<const std::uint8_t> input);

// Offered to the harness (harness.cpp).
void require(bool holds, std::string_view promise);  // aborts with the promise if it is broken
void accept();                                       // this input was taken as valid, all of it

// For the driver: whether accept() was called since the last time.
[[nodiscard]] bool takeAccepted();

[[nodiscard]] std::string_view asText(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::span<const std::uint8_t> asBytes(std::string_view text);

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/harness.h"

#include <cstdlib>
#include <iostream>
#include <utility>

namespace boresight::fuzz {
namespace {

bool lastAccepted = false;

}  // namespace

void require(bool holds, std::string_view promise)
{
    if (!holds) {
        std::cerr << "broken: " << promise << std::endl;
        std::abort();
    }
}

void accept()
{
    lastAccepted = true;
}

bool takeAccepted()
{
    return std::exchange(lastAccepted, false);
}

std::string_view asText(std::span<const std::uint8_t> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::uint8_t> asBytes(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace boresight::fuzz

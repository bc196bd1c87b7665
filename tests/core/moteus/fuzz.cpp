// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/moteus/exercise.h"

#include <cstddef>
#include <cstdint>

// The libFuzzer program; README.md of core/moteus says how to build and run it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    boresight::moteus::exercise(boresight::moteus::frameFromBytes({data, size}));
    return 0;
}

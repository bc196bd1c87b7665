// SPDX-License-Identifier: GPL-3.0-or-later
// The same harness under clang's libFuzzer, which is guided by code coverage (README.md).
#include "tests/fuzz/harness.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    boresight::fuzz::feed({data, size});
    return 0;
}

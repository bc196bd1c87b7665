// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

// Many inputs in a row, fed in a process of their own: whatever ends it (a broken promise, a sanitizer, a signal, an
// input that takes too long) leaves the guilty input behind.
namespace boresight::fuzz {

struct Campaign
{
    std::size_t inputs = 20'000;
    std::uint64_t seed = 1;
    // For one input. Processor time does not depend on what else the machine does: a thousand times what the slowest
    // input takes under ThreadSanitizer. The other one is for an input that waits for ever.
    std::chrono::seconds mostProcessorTime{30};
    std::chrono::seconds longest{600};
};

struct Failure
{
    std::size_t number =
        0;  // of the input, from 0; equal to the wanted inputs if the process failed at its end (a leak)
    std::string input;
    std::string how;  // "ended by signal 6"
};

struct Outcome
{
    std::size_t fed = 0;
    std::size_t accepted = 0;
    double seconds = 0.0;
    std::optional<Failure> failure;
};

[[nodiscard]] Outcome run(const Campaign& campaign);

}  // namespace boresight::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

// Runs many inputs in a separate process. If anything ends it (a broken promise, a sanitizer, a signal, an input that
// takes too long), the guilty input is known.
namespace boresight::fuzz {

struct Campaign
{
    std::size_t inputs = 20'000;
    std::uint64_t seed = 1;
    // Limits for one input. The processor time does not depend on other load of the computer: it is a thousand times
    // that of the slowest input under ThreadSanitizer. The other limit is for an input that waits for ever.
    std::chrono::seconds mostProcessorTime{30};
    std::chrono::seconds longest{600};
};

struct Failure
{
    std::size_t number =
        0;  // index of the input, from 0; equal to the number of inputs if the process failed at its end (a leak)
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

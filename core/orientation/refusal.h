// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <tl/expected.hpp>

// Why a message of the sensor was not used, and the counts. No part of a refused message is ever used. Plain values.
namespace boresight::orientation {

enum class Refusal
{
    WrongChecksum,
    NoChecksum,
    BadChecksum,  // not two hexadecimal digits
    Truncated,    // ends before its last field
    TooLong,
    FieldCount,  // wrong number of fields; for JSON: a member is missing
    Unit,
    NotANumber,
    NotFinite,
    OutOfRange,
    Retained,  // stored by the broker at an unknown time
    NotJson
};

inline constexpr std::size_t kRefusals = static_cast<std::size_t>(Refusal::NotJson) + 1;

struct Refused
{
    Refusal reason = Refusal::NotJson;
    std::string field;  // "azimuth"; empty if the whole message is refused

    bool operator==(const Refused&) const = default;
};

template <class T>
using Parsed = tl::expected<T, Refused>;

[[nodiscard]] inline tl::unexpected<Refused> refused(Refusal reason, std::string field = {})
{
    return tl::unexpected<Refused>(Refused{reason, std::move(field)});
}

// For logs, in English: "wrong checksum", "azimuth is not finite".
[[nodiscard]] std::string toText(const Refused& refused);

struct Counts
{
    std::uint64_t accepted = 0;
    std::array<std::uint64_t, kRefusals> refused{};
    std::uint64_t foreign = 0;            // sentences of other devices, other topics
    std::uint64_t chatter = 0;            // lines that are not sentences: start-up text, noise
    std::uint64_t lowerCaseChecksum = 0;  // accepted, although no known firmware writes them

    void count(Refusal reason) { ++refused[static_cast<std::size_t>(reason)]; }
    [[nodiscard]] std::uint64_t of(Refusal reason) const { return refused[static_cast<std::size_t>(reason)]; }
    [[nodiscard]] std::uint64_t allRefused() const
    {
        return std::accumulate(refused.begin(), refused.end(), std::uint64_t{0});
    }

    bool operator==(const Counts&) const = default;
};

}  // namespace boresight::orientation

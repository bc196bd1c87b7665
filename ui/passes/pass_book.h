// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/passes/pass.h"
#include "core/targets/cable_turns.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

// The coming passes of all satellites over the site. Values, shared between threads and never changed.
namespace boresight::ui {

using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;

struct BookedPass
{
    std::size_t satellite = 0;  // in PassBook::satellites
    passes::Pass pass;
};

// A new search finds a pass a little different. That of the same satellite is the same one if it is highest then.
[[nodiscard]] inline bool isSameMoment(UtcTime one, UtcTime other)
{
    return std::chrono::abs(one - other) < std::chrono::minutes(2);
}

// What a pass is judged by: of the antenna that it is tracked with, on this mount.
struct PassAntenna
{
    Angle beamWidth{};
    targets::MountReach reach{};

    bool operator==(const PassAntenna&) const = default;
};

struct PassBook
{
    Satellites satellites;
    Site site{};
    PassAntenna antenna;                      // in use
    std::map<std::int64_t, PassAntenna> own;  // of satellites with an antenna of their own, by their numbers
    std::vector<BookedPass> passes;           // in the order in which they begin

    [[nodiscard]] const orbit::ElementSet& elementsOf(const BookedPass& one) const
    {
        return satellites->at(one.satellite);
    }
    [[nodiscard]] const PassAntenna& antennaOf(const BookedPass& one) const
    {
        const auto found = own.find(elementsOf(one).number);
        return found == own.end() ? antenna : found->second;
    }
};

}  // namespace boresight::ui

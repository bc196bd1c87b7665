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

// The coming passes of all satellites over the site. The values are shared between threads and never change.
namespace boresight::ui {

using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;

struct BookedPass
{
    std::size_t satellite = 0;  // index in PassBook::satellites
    passes::Pass pass;
};

// A new search finds the same pass with slightly different times. Two passes of one satellite are the same if their
// highest moments are this near.
[[nodiscard]] inline bool isSameMoment(UtcTime one, UtcTime other)
{
    return std::chrono::abs(one - other) < std::chrono::minutes(2);
}

// The properties of an antenna on this mount that decide how a pass is judged.
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
    PassAntenna antenna;  // the antenna in use
    std::map<std::int64_t, PassAntenna>
        own;                         // antennas of satellites with an antenna of their own, by satellite number
    std::vector<BookedPass> passes;  // in the order of their beginning

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"

#include <string>
#include <vector>

// The rows of tests/data/moonsun_azel.csv. Its first lines say how they were made and how accurate they are.
namespace boresight::ephemeris {

struct BodyRow
{
    Body body = Body::Sun;
    std::string site;
    UtcTime utc;
    SkyPointing direction;
    double kilometres = 0.0;
};

[[nodiscard]] std::vector<BodyRow> bodyTable();
[[nodiscard]] Site siteOf(const std::string& name);

// "2026-12-24T00:10:00Z"
[[nodiscard]] UtcTime utcOf(const std::string& text);

}  // namespace boresight::ephemeris

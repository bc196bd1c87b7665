// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pointing/region.h"

#include <QString>

#include <string>
#include <string_view>
#include <vector>

// The horizon as the text that planetarium and mount programs exchange (Stellarium, N.I.N.A., APCC, Cartes du Ciel,
// Radio Eyes): one point a line, azimuth from north and elevation, in degrees. Pure.
//
// Between the two may be blanks, a tab, a comma or a semicolon; a comma within a number is a decimal one. "#" begins a
// comment; a first line of words is a heading. The points may come in any order. 360° is 0°. No point at 0° is needed:
// the line goes on through north. Where an azimuth is given more than once, as at the side of a tower, the highest
// elevation counts: the beam then stays away from more than the horizon, never from less.
namespace boresight::profile {

struct HorizonText
{
    std::vector<pointing::HorizonPoint> points;  // by azimuth, each once
    int merged = 0;                              // points dropped because another point at their azimuth is higher

    bool operator==(const HorizonText&) const = default;
};

// The error lists all problems, one "FILE:LINE: reason" per line. Negative azimuths are refused, because files with
// -180…180° often count from south.
[[nodiscard]] Result<HorizonText> parseHorizon(std::string_view text, const QString& fileName);

// Includes points at 0° and 360°, for programs that do not continue the line through north.
[[nodiscard]] std::string toHorizonText(const std::vector<pointing::HorizonPoint>& horizon,
                                        const std::string& mountName);

}  // namespace boresight::profile

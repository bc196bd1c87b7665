// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pointing/region.h"

#include <QString>

#include <string>
#include <string_view>
#include <vector>

// The horizon in the text format of planetarium and mount programs (Stellarium, N.I.N.A., APCC, Cartes du Ciel, Radio
// Eyes): one point per line, with azimuth from north and elevation in degrees. Pure.
//
// The two numbers are separated by blanks, a tab, a comma or a semicolon. A comma within a number is a decimal comma. A
// comment begins with "#", and a first line of words is a heading. The points may be in any order. 360° is 0°. A point
// at 0° is not needed, because the line continues through north. If an azimuth occurs more than once, as at the side of
// a tower, the highest elevation is used. So the beam never comes closer to an obstacle than the horizon says.
namespace boresight::profile {

struct HorizonText
{
    std::vector<pointing::HorizonPoint> points;  // sorted by azimuth, each azimuth once
    int merged = 0;  // points that were dropped because a point with the same azimuth is higher

    bool operator==(const HorizonText&) const = default;
};

// The error lists all problems, one "FILE:LINE: reason" per line. Negative azimuths are refused, because files with
// -180…180° often count from south.
[[nodiscard]] Result<HorizonText> parseHorizon(std::string_view text, const QString& fileName);

// Includes points at 0° and 360°, for programs that do not continue the line through north.
[[nodiscard]] std::string toHorizonText(const std::vector<pointing::HorizonPoint>& horizon,
                                        const std::string& mountName);

}  // namespace boresight::profile

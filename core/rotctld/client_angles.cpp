// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/client_angles.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <string>

namespace boresight::rotctld {

std::optional<Angle> degreesIn(std::string_view text)
{
    std::string number(text);
    if (number.find_first_not_of("+-.,0123456789") != std::string::npos) {
        return std::nullopt;
    }
    if (const std::size_t comma = number.find(','); comma != std::string::npos) {
        number[comma] = '.';
    }
    const auto degrees = parseFinite(number);
    return degrees ? std::optional(Angle::fromDegrees(*degrees)) : std::nullopt;
}

Result<> inReach(Angle azimuth, Angle elevation)
{
    constexpr Angle kMostAzimuth = Angle::fromDegrees(3600.0);
    if (abs(azimuth) > kMostAzimuth) {
        return failure(ErrorCode::OutOfRange, Text::tr("azimuth %1 is outside -3600°…3600°").arg(degreesText(azimuth)));
    }
    if (elevation < -90_deg || elevation > 180_deg) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("elevation %1 is outside -90°…180°").arg(degreesText(elevation)));
    }
    return {};
}

}  // namespace boresight::rotctld

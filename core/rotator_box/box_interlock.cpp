// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/box_interlock.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight {

TravelRange stepsIn(const TravelRange& travel, Angle step)
{
    constexpr double kRounding = 1e-6;  // steps
    return {.min = step * std::ceil(travel.min / step - kRounding),
            .max = step * std::floor(travel.max / step + kRounding)};
}

QString tableOf(Axis axis)
{
    return axis == Axis::Azimuth ? QStringLiteral("azimuth") : QStringLiteral("elevation");
}

std::array<AxisCapabilities, 2> asInProfile(const AxisCapabilities& each, const profile::Profile& profile)
{
    std::array<AxisCapabilities, 2> both{each, each};
    for (const Axis axis : kAxes) {
        AxisCapabilities& one = both[index(axis)];
        const double steps = profile.axis(axis).stepsPerTurn;
        one.step = steps > 0.0 ? std::max(one.step, Angle::fromTurns(1.0 / steps)) : one.step;
        one.rareStarts = profile.rotator.rareStarts == profile::RareStarts::On;
    }
    return both;
}

// A new profile still has the default sign and offset, which belong to another mount. They are accepted.
Result<> countsAsTheRotator(const profile::Profile& profile, Axis axis)
{
    const pointing::AxisGeometry& geometry = profile.axis(axis).geometry;
    const pointing::AxisGeometry usual = profile::Profile().axis(axis).geometry;
    const bool plain = geometry.sign == 1 && geometry.offset == Angle{};
    if (plain || (geometry.sign == usual.sign && geometry.offset == usual.offset)) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("This rotator counts its angles itself: %1.sign and %1.offset_deg have no "
                            "effect on it. Set them to 1 and 0, and calibrate the count at its box.")
                       .arg(tableOf(axis)));
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/client_target.h"

namespace boresight::rotctld {

Result<SkyPointing> completed(const Rotator& rotator, std::optional<Angle> azimuth, std::optional<Angle> elevation)
{
    const auto turned = [&](Angle angle) { return rotator.limits().turned(angle); };
    if (azimuth && elevation) {
        return SkyPointing{.azimuth = turned(*azimuth), .elevation = *elevation};
    }
    return rotator.target().map([&](const SkyPointing& held) {
        return SkyPointing{.azimuth = azimuth ? turned(*azimuth) : held.azimuth,
                           .elevation = elevation.value_or(held.elevation)};
    });
}

Result<> pointTo(Rotator& rotator, const Client& client, const Result<SkyPointing>& place, LineOutcome& outcome)
{
    outcome.motion = true;
    return place
        .and_then([&](const SkyPointing& wanted) {
            outcome.point = wanted;
            return rotator.pointTo(client, {.azimuth = wanted.azimuth, .elevation = wanted.elevation});
        })
        .map([&](const QString& became) { outcome.became = became; });
}

}  // namespace boresight::rotctld

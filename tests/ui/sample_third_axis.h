// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// A third axis that holds its place.
namespace boresight::samples {

inline ThirdAxisStatus thirdAxis()
{
    return {.name = QStringLiteral("polarisation"),
            .state = ThirdAxisStatus::State::Holding,
            .place = 12.34_deg,
            .age = std::chrono::milliseconds(20),
            .travel = {.min = -90_deg, .max = 90_deg},
            .fastest = 5_deg_s,
            .mode = QStringLiteral("position (10)"),
            .boardTemperature = 31.4};
}

}  // namespace boresight::samples

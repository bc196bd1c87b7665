// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/motion_state.h"

namespace boresight::ui {

bool followsAClient(const StationStatus& status)
{
    return status.state == StationState::Track && status.commander.kind == SourceKind::Client;
}

bool isMoving(const StationStatus& status)
{
    switch (status.state) {
        case StationState::Slew:
        case StationState::Track:
        case StationState::Jog:
        case StationState::Calibrate:
            return true;
        default:
            return status.azimuth.state == AxisState::Moving || status.elevation.state == AxisState::Moving;
    }
}

}  // namespace boresight::ui

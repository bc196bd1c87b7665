// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_status.h"

namespace boresight {

QString word(StationState state)
{
    switch (state) {
        case StationState::Disconnected:
            return QStringLiteral("DISCONNECTED");
        case StationState::Standby:
            return QStringLiteral("STANDBY");
        case StationState::Hold:
            return QStringLiteral("HOLD");
        case StationState::Slew:
            return QStringLiteral("SLEW");
        case StationState::Track:
            return QStringLiteral("TRACK");
        case StationState::Jog:
            return QStringLiteral("JOG");
        case StationState::Parked:
            return QStringLiteral("PARKED");
        case StationState::Calibrate:
            return QStringLiteral("CALIBRATE");
        case StationState::Stopped:
            return QStringLiteral("STOPPED");
        case StationState::Fault:
            return QStringLiteral("FAULT");
    }
    return {};
}

QString word(AxisState state)
{
    switch (state) {
        case AxisState::NoData:
            return QStringLiteral("NO DATA");
        case AxisState::Holding:
            return QStringLiteral("HOLDING");
        case AxisState::Moving:
            return QStringLiteral("MOVING");
        case AxisState::Limit:
            return QStringLiteral("LIMIT");
        case AxisState::Stopped:
            return QStringLiteral("STOPPED");
        case AxisState::Fault:
            return QStringLiteral("FAULT");
        case AxisState::On:
            return QStringLiteral("ON");
        case AxisState::Off:
            return QStringLiteral("OFF");
    }
    return {};
}

}  // namespace boresight

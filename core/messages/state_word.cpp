// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/state_word.h"

namespace boresight {

QString protocolWord(StationState state)
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

}  // namespace boresight

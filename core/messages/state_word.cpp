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

QString protocolWord(const BrakeStatus& brake)
{
    if (!brake.problem.isEmpty()) {
        return QStringLiteral("failed");
    }
    switch (brake.state) {
        case brake::BrakeState::Set:
            return QStringLiteral("set");
        case brake::BrakeState::Releasing:
            return QStringLiteral("opens");
        case brake::BrakeState::Released:
            return QStringLiteral("open");
        case brake::BrakeState::Setting:
            return QStringLiteral("closes");
    }
    return {};
}

QString protocolWord(const end_switches::EndSwitch& one)
{
    return (one.axis == Axis::Azimuth ? QStringLiteral("azimuth ") : QStringLiteral("elevation ")) +
           (one.isUpper ? QStringLiteral("upper") : QStringLiteral("lower"));
}

QString protocolWord(ThirdAxisStatus::State state)
{
    switch (state) {
        case ThirdAxisStatus::State::Off:
            return QStringLiteral("off");
        case ThirdAxisStatus::State::Holding:
            return QStringLiteral("holding");
        case ThirdAxisStatus::State::Moving:
            return QStringLiteral("moving");
        case ThirdAxisStatus::State::Fault:
            return QStringLiteral("fault");
        case ThirdAxisStatus::State::NoData:
            break;
    }
    return QStringLiteral("no data");
}

QString protocolWord(end_switches::SwitchState state)
{
    switch (state) {
        case end_switches::SwitchState::Free:
            return QStringLiteral("free");
        case end_switches::SwitchState::Pressed:
            return QStringLiteral("pressed");
        case end_switches::SwitchState::Unread:
            break;
    }
    return QStringLiteral("unread");
}

}  // namespace boresight

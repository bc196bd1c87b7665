// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/finding.h"

#include "core/base/text.h"

namespace boresight::supervision {

QString key(Finding finding)
{
    switch (finding) {
        case Finding::FollowingError:
            return QStringLiteral("following_error");
        case Finding::Stalled:
            return QStringLiteral("stalled");
        case Finding::WrongWay:
            return QStringLiteral("wrong_way");
        case Finding::MovesUncommanded:
            return QStringLiteral("moves_uncommanded");
        case Finding::EncoderJump:
            return QStringLiteral("encoder_jump");
        case Finding::OutsideTravel:
            return QStringLiteral("outside_travel");
        case Finding::RepliesLate:
            return QStringLiteral("replies_late");
        case Finding::SupplyLow:
            return QStringLiteral("supply_low");
        case Finding::SupplyHigh:
            return QStringLiteral("supply_high");
        case Finding::BoardHot:
            return QStringLiteral("board_hot");
        case Finding::MotorHot:
            return QStringLiteral("motor_hot");
        case Finding::TorqueHigh:
            return QStringLiteral("torque_high");
        case Finding::TorqueGuard:
            return QStringLiteral("torque_guard");
    }
    return {};
}

QString remedy(Finding finding)
{
    switch (finding) {
        case Finding::FollowingError:
            return Text::tr(
                "Look for wind, ice or a tight cable; else lower speed and acceleration or check the drive's gains.");
        case Finding::Stalled:
            return Text::tr("Look what blocks the axis: a cable, a lock, ice, a coupling that slips. Free it.");
        case Finding::WrongWay:
            return Text::tr(
                "Do not re-arm before the motor was calibrated again and its phases and the encoder were checked.");
        case Finding::MovesUncommanded:
            return Text::tr(
                "Look for wind, a person at the antenna or a slipping gear. Secure the axis, then check the position.");
        case Finding::EncoderJump:
            return Text::tr(
                "The angle shown may be wrong. Compare it with the antenna, check encoder and wiring, and that no "
                "other program sets the drive's position.");
        case Finding::OutsideTravel:
            return Text::tr("Jog the axis back inside while you watch the cable.");
        case Finding::RepliesLate:
            return Text::tr("Check the load of the bus and of this computer, the cable and the termination.");
        case Finding::SupplyLow:
            return Text::tr("Check supply, battery and cable; lower the acceleration.");
        case Finding::SupplyHigh:
            return Text::tr(
                "Braking feeds the supply: lower the acceleration, set servo.max_regen_power_W, or add a battery or a "
                "brake resistor.");
        case Finding::BoardHot:
            return Text::tr(
                "Give the board air and shade, or move less and slower; at its limit the drive lets the axis go.");
        case Finding::MotorHot:
            return Text::tr("Let the motor cool down; look for friction or a load out of balance.");
        case Finding::TorqueHigh:
            return Text::tr("Look for wind, ice, friction or a load out of balance.");
        case Finding::TorqueGuard:
            return Text::tr("A cable may be wound up: look at it, and turn the other way.");
    }
    return {};
}

bool saysRearm(Finding finding)
{
    return finding == Finding::WrongWay;
}

}  // namespace boresight::supervision

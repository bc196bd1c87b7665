// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

// The problems of an axis that Boresight itself finds, whatever the drive reports. Plain values for alarms.
namespace boresight::supervision {

enum class Symptom
{
    FollowingError,    // too far behind or ahead of its set-point
    Stalled,           // does not move although commanded
    WrongWay,          // moves against its command
    MovesUncommanded,  // moves although it should stand still; only a hint while the drive is off
    EncoderJump,       // the reported angle changed faster than the axis can turn
    OutsideTravel,
    RepliesLate,
    SupplyLow,
    SupplyHigh,
    BoardHot,
    MotorHot,
    TorqueHigh,
    TorqueGuard  // too much torque while the cable wrap of the axis is unknown, or was only entered
};
inline constexpr int kSymptomCount = 13;

enum class Weight
{
    Hint,  // notify the operator
    Stop   // stop the mount; only an explicit re-arm lets it move again
};

struct Observed
{
    Symptom symptom = Symptom::FollowingError;
    Weight weight = Weight::Hint;
    QString what;  // with numbers: "the azimuth does not move: it moved 0.1° in 0.80 s instead of 2.4°"

    bool operator==(const Observed&) const = default;
};

}  // namespace boresight::supervision

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

// What Boresight itself sees going wrong on an axis, whatever the drive says about it. Plain values for alarms.
namespace boresight::supervision {

enum class Symptom
{
    FollowingError,    // too far behind or ahead of its set-point
    Stalled,           // does not move although commanded
    WrongWay,          // moves against its command
    MovesUncommanded,  // moves although it should stand: a hint while the drive is off
    EncoderJump,       // the reported angle changed faster than the axis can turn
    OutsideTravel,
    RepliesLate,
    SupplyLow,
    SupplyHigh,
    BoardHot,
    MotorHot,
    TorqueHigh,
    TorqueGuard  // against resistance while the turn of the axis is unknown
};
inline constexpr int kSymptomCount = 13;

enum class Weight
{
    Hint,  // notify the operator
    Stop   // come to rest, targets to actual, explicit re-arm
};

struct Observed
{
    Symptom symptom = Symptom::FollowingError;
    Weight weight = Weight::Hint;
    QString what;  // with the numbers: "the azimuth does not move: 2.4° commanded in 0.80 s, 0.1° moved"

    bool operator==(const Observed&) const = default;
};

}  // namespace boresight::supervision

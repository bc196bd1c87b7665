// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/system/simulated_station.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// What is put out of order and when, and what must come of it: the rows of FAULTS.md. Plain values.
namespace boresight::system_test {

enum class Moment
{
    AtRest,         // holding where a client has sent it
    InSlew,         // at full speed, 14° before the upper end of azimuth
    WhileBraking,   // of the same slew, 4° before the end
    AtLowerEnd,     // the last 0.4° before the lower ends of both travels
    InTrack,        // following Gpredict through a pass
    InJog,          // an operator holds the keys, towards the upper end of azimuth
    WhileEnabling,  // the first ticks of the first motion
};

enum class Outcome
{
    Latches,  // nothing moves before somebody re-arms
    GoesOn,   // the mount does what it was asked to
};

// The axes whose drive was hurt; the others are healthy and hold.
enum class Hurt
{
    None,
    Azimuth,
    Elevation,
    Both,
};

inline constexpr Seconds kFaultLasts{3.0};
inline constexpr Seconds kOneReply = 1.5 * SimulatedStation::kTick;
inline constexpr Seconds kFiveReplies = 5.5 * SimulatedStation::kTick;

struct Fault
{
    std::string name;
    std::vector<sim::Injection> injections{};  // from the moment on; without a duration of their own for kFaultLasts
    std::function<void(SimulatedStation&)> once{};
    std::function<void(SimulatedStation&)> eachTick{};  // another program at work, for kFaultLasts
    Seconds stall{0.0};                                 // this computer does nothing for so long
    Outcome outcome = Outcome::Latches;
    Hurt hurt = Hurt::Both;
    std::string alarm{};        // words of the alarm; empty: there need not be one
    Seconds alarmWithin{0.25};  // 0.3 s on the screen, which is updated every 0.05 s
    Seconds stillWithin{0.2};   // the hurt axes
    Seconds othersStillWithin{2.0};
    Angle beyond = Angle::fromDegrees(0.2);        // the travel
    std::optional<double> pushesOn{};              // Nm: at most so much on a blocked axis, when the fault ends
    Angle strays = Angle::fromDegrees(0.3);        // from where it stood, at rest, until somebody re-arms
    Angle arrives = Angle::fromDegrees(0.1);       // this near to its next target
    Angle springsBack = Angle::fromDegrees(0.03);  // when the fault is over: backlash, and the drive coming to rest
};

struct FaultCase
{
    Fault fault;
    Moment moment = Moment::AtRest;
};

[[nodiscard]] std::string word(Moment moment);
[[nodiscard]] std::vector<FaultCase> faultCases();

}  // namespace boresight::system_test

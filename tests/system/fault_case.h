// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/system/simulated_station.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The faults, their moments and the expected results: the rows of FAULTS.md. Plain values.
namespace boresight::system_test {

enum class Moment
{
    AtRest,         // holding where a client has sent the mount
    InSlew,         // at full speed, 14° before the upper end of azimuth
    WhileBraking,   // of the same slew, 4° before the end
    AtLowerEnd,     // the last 0.4° before the lower ends of both travels
    InTrack,        // following Gpredict during a pass
    InJog,          // an operator jogs by keys towards the upper end of azimuth
    WhileEnabling,  // the first ticks of the first motion
};

enum class Outcome
{
    Latches,  // nothing moves before a re-arm
    GoesOn,   // the mount completes the requested motion
};

// The axes with the faulty drive. The other axes are healthy and hold.
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
    // they start at the moment of the fault; without their own duration they last for kFaultLasts
    std::vector<sim::Injection> injections{};
    std::function<void(SimulatedStation&)> once{};
    std::function<void(SimulatedStation&)> eachTick{};  // another program acts, for kFaultLasts
    Seconds stall{0.0};                                 // this computer stalls for this time
    Outcome outcome = Outcome::Latches;
    Hurt hurt = Hurt::Both;
    std::string alarm{};        // words of the alarm; empty if no alarm is required
    Seconds alarmWithin{0.25};  // 0.3 s on the screen, which is updated every 0.05 s
    Seconds stillWithin{0.2};   // the faulty axes
    Seconds othersStillWithin{2.0};
    Angle beyond = Angle::fromDegrees(0.2);        // outside the travel
    std::optional<double> pushesOn{};              // Nm: the largest torque on a blocked axis when the fault ends
    Angle strays = Angle::fromDegrees(0.3);        // from the place where it stood still, until the re-arm
    Angle arrives = Angle::fromDegrees(0.1);       // distance to its next target
    Angle springsBack = Angle::fromDegrees(0.03);  // after the end of the fault: backlash, and the drive settling
};

struct FaultCase
{
    Fault fault;
    Moment moment = Moment::AtRest;
};

[[nodiscard]] std::string word(Moment moment);
[[nodiscard]] std::vector<FaultCase> faultCases();

}  // namespace boresight::system_test

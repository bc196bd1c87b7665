// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/fault_case.h"

#include "core/moteus/codec.h"

#include <gtest/gtest.h>

namespace boresight::system_test {
namespace {

using sim::FaultKind;
using sim::Injection;

const std::vector<Moment> kEverywhere{Moment::AtRest, Moment::InSlew, Moment::InTrack, Moment::InJog,
                                      Moment::WhileEnabling};
const std::vector<Moment> kInMotion{Moment::InSlew, Moment::InTrack, Moment::InJog, Moment::WhileEnabling};
const std::vector<Moment> kEverywhereAndAtTheEnds{Moment::AtRest,       Moment::InSlew,  Moment::WhileBraking,
                                                  Moment::AtLowerEnd,   Moment::InTrack, Moment::InJog,
                                                  Moment::WhileEnabling};
const std::vector<Moment> kFast{Moment::InSlew, Moment::InTrack};

// The time in which an axis without power coasts from full speed to standstill, by friction alone.
constexpr Seconds kCoasting{2.6};
// The time until a blocked axis is detected: the way to the obstacle, then 0.8 s with a commanded motion.
constexpr Seconds kBlockedKnown{1.1};

// How far an axis springs when the obstacle gives way: the integrator of the drive is wound up.
constexpr Angle kWoundUp = Angle::fromDegrees(0.3);

// How far a slipping axis may move: its drive trusts the encoder, and no program can see an error within one turn of
// the rotor.
constexpr Angle kSlips = Angle::fromDegrees(2.3);
constexpr Angle kWindBends = Angle::fromDegrees(1.5);
constexpr Angle kStormTurns = Angle::fromDegrees(25.0);  // the drive gives up at 10°

// The torque against unbalance, wind and friction of an axis that stands still.
constexpr double kHolds = 15.0;  // Nm

struct Group
{
    Fault fault;
    std::vector<Moment> moments;
};

std::string name(Axis axis)
{
    return axis == Axis::Azimuth ? "azimuth" : "elevation";
}

Hurt hurt(Axis axis)
{
    return axis == Axis::Azimuth ? Hurt::Azimuth : Hurt::Elevation;
}

// A frame of another program that one drive receives. Boresight does not receive its reply.
void order(SimulatedStation& rig, Axis axis, const moteus::Command& command)
{
    const auto frame =
        moteus::encode({.destination = static_cast<std::uint8_t>(axis == Axis::Azimuth ? 1 : 2), .command = command});
    ASSERT_TRUE(frame);
    static_cast<void>(rig.link->pair().exchange(*frame, rig.link->pair().now()));
}

// An obstacle that the axis meets 0.1° farther on.
void jamAhead(SimulatedStation& rig, Axis axis)
{
    const sim::AxisTruth now = rig.link->truth(axis);
    const double ahead = now.rate < AngularRate::fromDegrees(-0.01) ? -0.1 : 0.1;
    rig.link->inject(
        {.kind = FaultKind::Jam, .axis = axis, .duration = kFaultLasts, .value = now.angle.degrees() + ahead});
}

double reported(SimulatedStation& rig, Axis axis)
{
    return rig.link->pair().drive(axis).reportedPosition();
}

std::vector<Group> lostLines()
{
    const std::string noReply = "drive does not reply";
    const std::string noneReplies = "Neither drive replies";
    std::vector<Group> groups{
        {.fault = {.name = "CAN cable cut",
                   .injections = {{.kind = FaultKind::LostCommand, .value = 1.0}},
                   .alarm = noneReplies},
         .moments = kEverywhereAndAtTheEnds},
        {.fault = {.name = "adapter answers ERR to every frame",
                   .injections = {{.kind = FaultKind::AdapterError}},
                   .alarm = noneReplies},
         .moments = kEverywhere},
        {.fault = {.name = "bus off", .injections = {{.kind = FaultKind::BusOff}}, .alarm = "bus-off"},
         .moments = kEverywhere},
        {.fault = {.name = "every reply garbled",
                   .injections = {{.kind = FaultKind::CorruptLine, .value = 1.0}},
                   .alarm = noneReplies},
         .moments = kEverywhere},
    };
    for (const Axis axis : kAxes) {
        groups.push_back({.fault = {.name = name(axis) + " drive cut off",
                                    .injections = {{.kind = FaultKind::LostCommand, .axis = axis, .value = 1.0}},
                                    .hurt = hurt(axis),
                                    .alarm = name(axis) + " " + noReply},
                          .moments = kEverywhere});
        groups.push_back({.fault = {.name = name(axis) + " drive receives and never answers",
                                    .injections = {{.kind = FaultKind::Silence, .axis = axis}},
                                    .hurt = hurt(axis),
                                    .alarm = name(axis) + " " + noReply},
                          .moments = kEverywhere});
        groups.push_back(
            {.fault = {.name = name(axis) + " drive receives nothing for 0.16 s",
                       .injections =
                           {{.kind = FaultKind::LostCommand, .axis = axis, .duration = Seconds(0.16), .value = 1.0}},
                       .hurt = hurt(axis),
                       .alarm = name(axis) + " drive timed out"},
             .moments = kEverywhere});
    }
    return groups;
}

std::vector<Group> roughLines()
{
    const auto goesOn = [](const std::string& name, const Injection& injection, const std::string& alarm = {}) {
        return Fault{
            .name = name, .injections = {injection}, .outcome = Outcome::GoesOn, .hurt = Hurt::None, .alarm = alarm};
    };
    return {
        {.fault = goesOn("one reply lost", {.kind = FaultKind::LostReply, .duration = kOneReply, .value = 1.0}),
         .moments = {Moment::InTrack}},
        {.fault = goesOn("every fifth reply lost", {.kind = FaultKind::LostReply, .value = 0.2}),
         .moments = {Moment::InSlew, Moment::InTrack}},
        {.fault = goesOn("every fifth reply garbled", {.kind = FaultKind::CorruptLine, .value = 0.2}),
         .moments = {Moment::InSlew, Moment::InTrack}},
        {.fault = goesOn("adapter never sends OK", {.kind = FaultKind::MissingOk}),
         .moments = {Moment::InSlew, Moment::InTrack}},
        {.fault = goesOn("replies 0.05 s late", {.kind = FaultKind::LateReply, .value = 0.05}),
         .moments = {Moment::InSlew, Moment::InTrack}},
    };
}

// The position in the replies of one drive is wrong, but the drive obeys. One such reply changes nothing.
std::vector<Group> falsePositions()
{
    std::vector<Group> groups;
    for (const Axis axis : kAxes) {
        const auto answers = [axis](const std::string& what, const Injection& injection) {
            Fault fault{.name = what, .injections = {injection}};
            fault.name.replace(what.find('#'), 1, name(axis));
            fault.injections[0].axis = axis;
            return fault;
        };
        const auto goesOn = [](Fault fault) {
            fault.outcome = Outcome::GoesOn;
            fault.hurt = Hurt::None;
            return fault;
        };
        const auto latches = [axis](Fault fault) {
            fault.hurt = hurt(axis);
            fault.alarm = name(axis);
            return fault;
        };
        const double off = axis == Axis::Azimuth ? 90.0 : -60.0;
        const std::string degrees = std::to_string(static_cast<int>(off)) + "°";
        groups.push_back(
            {.fault = goesOn(answers("one reply of the # drive is wrong by " + degrees,
                                     {.kind = FaultKind::FalsePosition, .duration = kOneReply, .value = off})),
             .moments = kEverywhereAndAtTheEnds});
        groups.push_back({.fault = latches(answers("replies of the # drive are wrong by " + degrees,
                                                   {.kind = FaultKind::FalsePosition, .value = off})),
                          .moments = kEverywhereAndAtTheEnds});
        groups.push_back({.fault = latches(answers("replies of the # drive are wrong by 5°",
                                                   {.kind = FaultKind::FalsePosition, .value = 5.0})),
                          .moments = kEverywhere});
        groups.push_back({.fault = goesOn(answers("one reply of the # drive has no position",
                                                  {.kind = FaultKind::PositionNaN, .duration = kOneReply})),
                          .moments = kEverywhere});
        groups.push_back({.fault = latches(answers("# position NaN", {.kind = FaultKind::PositionNaN})),
                          .moments = kEverywhereAndAtTheEnds});
        groups.push_back({.fault = latches(answers("# position infinite", {.kind = FaultKind::PositionInfinite})),
                          .moments = kEverywhere});
        groups.push_back(
            {.fault = latches(answers("# replies end before the position", {.kind = FaultKind::PositionMissing})),
             .moments = kEverywhere});
    }
    return groups;
}

std::vector<Group> strangeReplies()
{
    const auto goesOn = [](const std::string& name, const Injection& injection) {
        return Fault{.name = name, .injections = {injection}, .outcome = Outcome::GoesOn, .hurt = Hurt::None};
    };
    const auto ofAzimuth = [](const std::string& name, const Injection& injection) {
        return Fault{.name = name, .injections = {injection}, .hurt = Hurt::Azimuth, .alarm = "azimuth"};
    };
    std::vector<Group> groups{
        {.fault = ofAzimuth("azimuth drive answers under the unknown id 7",
                            {.kind = FaultKind::ForeignId, .axis = Axis::Azimuth, .value = 7.0}),
         .moments = kEverywhere},
        {.fault = goesOn("replies of both drives exchanged once",
                         {.kind = FaultKind::ExchangedReplies, .duration = kOneReply}),
         .moments = kEverywhere},
        {.fault = {.name = "replies of both drives exchanged", .injections = {{.kind = FaultKind::ExchangedReplies}}},
         .moments = kEverywhere},
        {.fault = goesOn("each reply comes twice", {.kind = FaultKind::DoubledReply}), .moments = kEverywhere},
        {.fault =
             goesOn("one reply is 0.5 s old", {.kind = FaultKind::StaleReply, .duration = kOneReply, .value = 0.5}),
         .moments = kEverywhere},
        {.fault = ofAzimuth("azimuth replies are 0.5 s old",
                            {.kind = FaultKind::StaleReply, .axis = Axis::Azimuth, .value = 0.5}),
         .moments = {Moment::InSlew}},
        {.fault = goesOn("no supply voltage in the replies", {.kind = FaultKind::SupplyNaN}), .moments = kEverywhere},
        {.fault = goesOn("no temperatures in the replies", {.kind = FaultKind::TemperatureNaN}),
         .moments = kEverywhere},
    };
    for (const Axis axis : kAxes) {
        groups.push_back({.fault = {.name = name(axis) + " encoder slips by 2°",
                                    .injections = {{.kind = FaultKind::EncoderSlip, .axis = axis, .value = 2.0}},
                                    .hurt = hurt(axis),
                                    .alarm = name(axis),
                                    .stillWithin = Seconds(2.0),
                                    .strays = kSlips,
                                    .arrives = kSlips},
                          .moments = kEverywhere});
    }
    return groups;
}

std::vector<Group> driveFaults()
{
    std::vector<Group> groups;
    for (const Axis axis : kAxes) {
        for (const int code : {33, 34, 35, 38, 39, 40, 49}) {
            const bool everywhere = code == (axis == Axis::Azimuth ? 38 : 35);
            groups.push_back({.fault = {.name = name(axis) + " drive fault " + std::to_string(code),
                                        .injections = {{.kind = FaultKind::DriveFault, .axis = axis, .value = code}},
                                        .hurt = hurt(axis),
                                        .alarm = "drive reports fault " + std::to_string(code) + ": ",
                                        .stillWithin = kCoasting},
                              .moments = everywhere ? kEverywhere : std::vector{Moment::InSlew}});
        }
    }
    return groups;
}

std::vector<Group> supplies()
{
    const auto volts = [](double value) { return Injection{.kind = FaultKind::SupplyVoltage, .value = value}; };
    std::vector<Group> groups{
        {.fault = {.name = "loss of power for 3 s",
                   .injections = {{.kind = FaultKind::PowerLoss}},
                   .alarm = "Neither drive replies",
                   .stillWithin = kCoasting},
         .moments = kEverywhere},
        {.fault = {.name = "power off for 0.1 s",
                   .injections = {{.kind = FaultKind::PowerLoss, .duration = Seconds(0.1)}},
                   .alarm = "switched itself off",
                   .stillWithin = kCoasting},
         .moments = kEverywhere},
        {.fault = {.name = "supply 18 V",
                   .injections = {volts(18.0)},
                   .outcome = Outcome::GoesOn,
                   .hurt = Hurt::None,
                   .alarm = "supply",
                   .alarmWithin = Seconds(1.5)},
         .moments = {Moment::AtRest, Moment::InSlew}},
        {.fault = {.name = "supply 11 V",
                   .injections = {volts(11.0)},
                   .hurt = Hurt::None,
                   .alarm = "supply",
                   .alarmWithin = Seconds(1.5)},
         .moments = kFast},
        {.fault = {.name = "supply 3 V",
                   .injections = {volts(3.0)},
                   .alarm = "drive reports fault 40",
                   .stillWithin = kCoasting},
         .moments = kFast},
        {.fault = {.name = "supply 45 V",
                   .injections = {volts(45.0)},
                   .outcome = Outcome::GoesOn,
                   .hurt = Hurt::None,
                   .alarm = "supply",
                   .alarmWithin = Seconds(1.5)},
         .moments = {Moment::AtRest, Moment::InSlew}},
        {.fault = {.name = "supply 60 V",
                   .injections = {volts(60.0)},
                   .alarm = "drive reports fault 34",
                   .stillWithin = kCoasting},
         .moments = kFast},
    };
    for (const Axis axis : kAxes) {
        groups.push_back(
            {.fault = {.name = "power of the " + name(axis) + " drive off for 0.1 s",
                       .injections = {{.kind = FaultKind::BoardPowerLoss, .axis = axis, .duration = Seconds(0.1)}},
                       .hurt = hurt(axis),
                       .alarm = name(axis) + " drive switched itself off",
                       .stillWithin = kCoasting},
             .moments = kEverywhere});
    }
    return groups;
}

std::vector<Group> mechanics()
{
    std::vector<Group> groups{
        {.fault = {.name = "gust of 20 Nm for 2 s",
                   .injections = {{.kind = FaultKind::Wind, .duration = Seconds(2.0), .value = 20.0}},
                   .outcome = Outcome::GoesOn,
                   .hurt = Hurt::None,
                   .strays = kWindBends},
         .moments = {Moment::AtRest, Moment::InSlew, Moment::InTrack}},
        {.fault = {.name = "storm of 60 Nm for 1 s, 50 Nm allowed",
                   .injections =
                       {{.kind = FaultKind::Wind, .axis = Axis::Azimuth, .duration = Seconds(1.0), .value = -60.0}},
                   .hurt = Hurt::Azimuth,
                   .alarm = "azimuth",
                   // the excess of 10 Nm needs this time to push the axis 10° away (fault 49)
                   .alarmWithin = Seconds(1.1),
                   .stillWithin = Seconds(3.0),
                   .strays = kStormTurns},
         .moments = {Moment::AtRest, Moment::InTrack}},
    };
    for (const Axis axis : kAxes) {
        groups.push_back({.fault = {.name = name(axis) + " blocked",
                                    .injections = {{.kind = FaultKind::Stall, .axis = axis}},
                                    .hurt = hurt(axis),
                                    .alarm = "The " + name(axis) + " does not move",
                                    .alarmWithin = kBlockedKnown,
                                    .pushesOn = kHolds,
                                    .springsBack = kWoundUp},
                          .moments = kInMotion});
        groups.push_back({.fault = {.name = name(axis) + " blocked 0.1° farther on",
                                    .once = [axis](SimulatedStation& rig) { jamAhead(rig, axis); },
                                    .hurt = hurt(axis),
                                    .alarm = "The " + name(axis) + " does not move",
                                    .alarmWithin = kBlockedKnown,
                                    .stillWithin = Seconds(0.3),  // the axis moves on by 0.1° first
                                    .othersStillWithin = Seconds(2.5),
                                    .pushesOn = kHolds,
                                    .springsBack = kWoundUp},
                          .moments = kInMotion});
    }
    return groups;
}

std::vector<Group> others()
{
    std::vector<Group> groups{
        {.fault = {.name = "this computer stalls for 0.5 s",
                   .stall = Seconds(0.5),
                   .outcome = Outcome::GoesOn,
                   .hurt = Hurt::None},
         .moments = kEverywhereAndAtTheEnds},
        {.fault = {.name = "this computer stalls for 1.5 s",
                   .stall = Seconds(1.5),
                   .outcome = Outcome::GoesOn,
                   .hurt = Hurt::None},
         .moments = kEverywhereAndAtTheEnds},
        {.fault = {.name = "this computer stalls for 2.5 s", .stall = Seconds(2.5), .alarm = "timed out"},
         .moments = kEverywhere},
        {.fault = {.name = "this computer stalls for 20 s", .stall = Seconds(20.0), .alarm = "timed out"},
         .moments = kEverywhere},
        {.fault = {.name = "azimuth drive answers as the elevation drive",
                   .injections = {{.kind = FaultKind::DuplicateId, .axis = Axis::Azimuth}},
                   .alarm = "Neither drive replies"},
         .moments = kEverywhere},
    };
    groups.push_back({.fault = {.name = "power off for 0.1 s, azimuth drive returns with another register map",
                                .injections = {{.kind = FaultKind::PowerLoss, .duration = Seconds(0.1)},
                                               {.kind = FaultKind::RegisterMap, .axis = Axis::Azimuth, .value = 6}},
                                .alarm = "register map",
                                .alarmWithin = Seconds(6.0),
                                .stillWithin = kCoasting},
                      .moments = kEverywhere});
    for (const Axis axis : kAxes) {
        groups.push_back({.fault = {.name = "another program stops the " + name(axis) + " drive",
                                    .once = [axis](SimulatedStation& rig) { order(rig, axis, moteus::Stop{}); },
                                    .hurt = hurt(axis),
                                    .alarm = name(axis) + " drive switched itself off",
                                    .stillWithin = kCoasting},
                          .moments = {Moment::AtRest, Moment::InSlew, Moment::InTrack, Moment::InJog}});
        groups.push_back({.fault = {.name = "another program stops the " + name(axis) + " drive",
                                    .once = [axis](SimulatedStation& rig) { order(rig, axis, moteus::Stop{}); },
                                    .outcome = Outcome::GoesOn,
                                    .hurt = Hurt::None},
                          .moments = {Moment::WhileEnabling}});
        groups.push_back({.fault = {.name = "another program shifts the reported angle of " + name(axis) + " by 7.2°",
                                    .once =
                                        [axis](SimulatedStation& rig) {
                                            order(rig, axis, moteus::SetOutputExact{reported(rig, axis) + 7.2 / 360.0});
                                        },
                                    .hurt = hurt(axis),
                                    .alarm = name(axis),
                                    .stillWithin = Seconds(2.0)},
                          .moments = kEverywhere});
    }
    groups.push_back({.fault = {.name = "another program brakes the azimuth drive",
                                .eachTick = [](SimulatedStation& rig) { order(rig, Axis::Azimuth, moteus::Brake{}); },
                                .hurt = Hurt::Azimuth,
                                .alarm = "azimuth drive",
                                .stillWithin = kCoasting},
                      .moments = kEverywhere});
    return groups;
}

}  // namespace

std::string word(Moment moment)
{
    switch (moment) {
        case Moment::AtRest:
            return "standing still";
        case Moment::InSlew:
            return "in slew";
        case Moment::WhileBraking:
            return "while braking";
        case Moment::AtLowerEnd:
            return "at the lower ends";
        case Moment::InTrack:
            return "in track";
        case Moment::InJog:
            return "in jog";
        case Moment::WhileEnabling:
            return "while enabling";
    }
    return {};
}

std::vector<FaultCase> faultCases()
{
    std::vector<FaultCase> cases;
    for (const auto& groups : {lostLines(), roughLines(), falsePositions(), strangeReplies(), driveFaults(), supplies(),
                               mechanics(), others()}) {
        for (const Group& group : groups) {
            for (const Moment moment : group.moments) {
                cases.push_back({.fault = group.fault, .moment = moment});
            }
        }
    }
    return cases;
}

}  // namespace boresight::system_test

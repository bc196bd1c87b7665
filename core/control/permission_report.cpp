// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/permission_report.h"

#include "core/control/gates.h"
#include "core/control/home_run_gate.h"
#include "core/control/typed_line_gate.h"
#include "core/control/xy_gate.h"
#include "core/mount/third_axis.h"

namespace boresight {
namespace {

const Source kTheOperator{.kind = SourceKind::Operator};

void judge(Permissions& may, Action action, const Result<>& answer)
{
    may.refuse(action, answer ? QString() : answer.error().text);
}

struct Way
{
    JogDirection direction;
    Axis axis;
    bool upwards;
};
constexpr std::array kWays{
    Way{JogDirection::Up, Axis::Elevation, true}, Way{JogDirection::Down, Axis::Elevation, false},
    Way{JogDirection::Left, Axis::Azimuth, false}, Way{JogDirection::Right, Axis::Azimuth, true}};

AxisRates ratesOf(const Way& way, AngularRate rate)
{
    const AngularRate wanted = way.upwards ? rate : -rate;
    return way.axis == Axis::Azimuth ? AxisRates{.azimuth = wanted} : AxisRates{.elevation = wanted};
}

}  // namespace

Permissions PermissionReport::permissions() const
{
    Permissions may = Permissions::all();
    judge(may, Action::Move, Gates(m_of).mayMove(kTheOperator));
    judge(may, Action::Hold, Gates(m_of).mayHold(kTheOperator));
    judgePlaces(may);
    judgeJogs(may);
    judgeDrives(may);
    judgeControl(may);
    return may;
}

// Does not look for a way to a place, which takes too long for each status. That is done when the mount is sent there.
void PermissionReport::judgePlaces(Permissions& may) const
{
    const Gates gates(m_of);
    const Result<> point = gates.mayPoint(kTheOperator);
    judge(may, Action::Point, point);
    judge(may, Action::Track, point);
    judge(may, Action::TrackSun, point.and_then([&] { return gates.mayFaceSun(); }));
    judge(may, Action::FollowAzel, point);
    judge(may, Action::FollowPosition, point);
    judge(may, Action::Park, gates.mayPark(kTheOperator).and_then([&] { return gates.mayBeAt(gates.park()); }));
    judge(may, Action::OverrideWind, m_of.wind.mayOverride());
    judge(may, Action::Home, point.and_then([&] { return gates.mayBeAt(gates.home()); }));
    judge(may, Action::Horizon, point.and_then([&] { return hasElevationAxis(m_of); }));
    judge(may, Action::HoldAtEnd, gates.mayHoldAtEnd());
    judge(may, Action::UseAntenna, gates.mayUseAntenna());
    judge(may, Action::Unwind, point.and_then([&] { return hasCable(m_of); }).and_then([&] {
        return gates.unwound().map([](const AxisPosition&) {});
    }));
}

void PermissionReport::judgeJogs(Permissions& may) const
{
    const Gates gates(m_of);
    may.fastestJog = gates.fastestJog();
    const QString point = may.reason(Action::Point);
    for (const Way& way : kWays) {
        const Result<> jog = gates.hasAxis(way.axis)
                                 .and_then([&] { return gates.mayJog(ratesOf(way, may.fastestJog), kTheOperator); })
                                 .and_then([&] { return gates.isWayOn(way.axis, way.upwards); });
        judge(may, jogAction(way.direction), jog);
        judge(may, stepAction(way.direction), jog);
        may.refuse(stepAction(way.direction), point);
    }
}

void PermissionReport::judgeDrives(Permissions& may) const
{
    const DriveGates drives(m_of);
    for (const Axis axis : kAxes) {
        judge(may, setAction(axis), drives.maySet(axis));
        judge(may, chooseTurnAction(axis), drives.mayChooseTurn(axis));
        judge(may, switchOffAction(axis), drives.maySwitchOff(axis));
    }
    judgeGains(may);
    const Result<> rest = drives.drivesRest();
    judge(may, Action::ReadDrives, drives.mayReadDrives());
    judge(may, Action::FixDrives, drives.mayFixDrives());
    const Result<> boards = drives.mayChangeBoards();
    for (const Axis axis : kAxes) {
        judge(may, assignBoardAction(axis), boards);
        judge(may, setGearAction(axis), boards);
    }
    judge(may, Action::SwitchOff, drives.maySwitchOff());
    judge(may, Action::ReleaseBus, drives.mayLeaveBus());
    judge(may, Action::Reconnect, rest);
    judge(may, Action::ProveCrashStop, drives.mayProve(kTheOperator));
    judge(may, Action::EndProof, drives.mayEndProof());
    judge(may, Action::TakeBus, drives.mayTakeBus());
    judge(may, Action::TypeLine, mayTypeLine(m_of));
    judge(may, Action::MakeHomeRun, mayMakeHomeRun(m_of, kTheOperator));
}

// The connection of the mount adds what it knows of the gains.
void PermissionReport::judgeGains(Permissions& may) const
{
    const DriveGates drives(m_of);
    for (const Axis axis : kAxes) {
        const Result<> standing = drives.mayTune(axis);
        const Result<> off = drives.mayTuneOff(axis);
        for (const Action action : {Action::ReadAzimuthGains, Action::SetAzimuthGains, Action::PutAzimuthGainsBack}) {
            judge(may, actionOf(action, axis), standing);
        }
        judge(may, actionOf(Action::SetAzimuthFilter, axis), off);
        judge(may, actionOf(Action::StoreAzimuthGains, axis), off);
    }
}

// Judges taking and giving control, and what makes the mount ready to move again. Taking control is always permitted.
void PermissionReport::judgeControl(Permissions& may) const
{
    const Gates gates(m_of);
    const ThirdAxis* const third = m_of.mount.thirdAxis();
    const bool isThirdOnly = third != nullptr && third->isFaulted() && !m_of.arming.fault();
    judge(may, Action::Rearm, isThirdOnly ? Result<>{} : m_of.arming.mayRearm(kTheOperator));
    judge(may, Action::ResetStop, gates.mayResetStop());
    judge(may, Action::ClearTrim, gates.mayClearTrim());
    judge(may, Action::GiveAuthority, gates.mayGiveControl());
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <QSharedData>
#include <QString>

#include <array>
#include <cstddef>

// What the operator may request from the station now. Each refused action has a reason in words. Made on the station
// thread once per status, by the same gates that judge the requests. The screen shows the permissions and has no rules
// of its own. They only keep the screen from offering an action: the station still judges every request.
namespace boresight {

enum class JogDirection
{
    Up,
    Down,
    Left,  // counter-clockwise: azimuth gets smaller
    Right
};

enum class Action
{
    Move,   // any motion
    Hold,   // also leaves PARKED. Refused only in a strong wind to a parked mount, but not offered if nothing moves and
            // nothing is held
    Point,  // to a direction or angles: the wrap of both axes must be known
    Track,
    TrackSun,        // the profile may forbid the Sun
    FollowAzel,      // the Moon of WSJT-X
    FollowPosition,  // a balloon or rocket that reports its position
    ArmSchedule,     // of passes
    Park,
    OverrideWind,
    Home,
    Horizon,
    Unwind,
    HoldAtEnd,
    UseAntenna,
    JogUp,  // in the order of JogDirection, by at most Permissions::fastestJog; not at the end of the travel
    JogDown,
    JogLeft,
    JogRight,
    JogThirdAxisUp,  // towards larger angles
    JogThirdAxisDown,
    StepUp,
    StepDown,
    StepLeft,
    StepRight,
    SetAzimuth,  // gives the present angle another number; the axis must stand at a known angle
    SetElevation,
    ReadDrives,
    FixDrives,
    AssignAzimuthBoard,  // gives the only connected board the id of this axis
    AssignElevationBoard,
    SetAzimuthGear,  // writes the gear ratio of the profile into the drive
    SetElevationGear,
    SwitchOff,
    SwitchOffAzimuth,  // only this drive
    SwitchOffElevation,
    ReleaseBus,
    ProveCrashStop,
    Reconnect,
    AverageSensor,
    Swing,
    FollowSun,  // in the order of ephemeris::Body
    FollowMoon,
    FollowSunOverTheTop,
    FollowMoonOverTheTop,
    TakeSun,
    TakeMoon,
    ScanSun,
    ScanMoon,
    GivePower,
    TakeKnownPoint,
    ChangePoints,
    ProposeTerms,
    ApplyCalibration,
    DiscardCalibration,
    UndoCalibration,
    RedoCalibration,
    Rearm,
    ResetStop,
    ClearTrim,  // never refused, but not offered if the target has no trim
    TakeAuthority,
    GiveAuthority,
    ChooseAzimuthTurn,  // answers which wrap the axis is on
    ChooseElevationTurn,
    TakeBus,
    TypeLine,  // to the control box
    MakeHomeRun,
    EndProof,
    ReadAzimuthGains,  // of this drive
    ReadElevationGains,
    SetAzimuthGains,  // gains that the drive takes while it is on
    SetElevationGains,
    SetAzimuthFilter,  // gains for which the drive must be off
    SetElevationFilter,
    PutAzimuthGainsBack,
    PutElevationGainsBack,
    StoreAzimuthGains,
    StoreElevationGains,
    TuneAzimuth,  // a tuning run of this axis; its plan has the reason if one kind of run lacks room
    TuneElevation,
    EndTuning,
    Count
};

// Finds an action in a row of similar ones, such as one for each axis or direction: `first` is the first of the row.
template <class Which>
[[nodiscard]] constexpr Action actionOf(Action first, Which which)
{
    return static_cast<Action>(static_cast<int>(first) + static_cast<int>(which));
}

[[nodiscard]] constexpr Action jogAction(JogDirection direction)
{
    return actionOf(Action::JogUp, direction);
}

[[nodiscard]] constexpr Action stepAction(JogDirection direction)
{
    return actionOf(Action::StepUp, direction);
}

[[nodiscard]] constexpr Action followAction(ephemeris::Body body, bool overTheTop)
{
    return actionOf(overTheTop ? Action::FollowSunOverTheTop : Action::FollowSun, body);
}

[[nodiscard]] constexpr Action setAction(Axis axis)
{
    return actionOf(Action::SetAzimuth, axis);
}

[[nodiscard]] constexpr Action switchOffAction(Axis axis)
{
    return actionOf(Action::SwitchOffAzimuth, axis);
}

[[nodiscard]] constexpr Action assignBoardAction(Axis axis)
{
    return actionOf(Action::AssignAzimuthBoard, axis);
}

[[nodiscard]] constexpr Action setGearAction(Axis axis)
{
    return actionOf(Action::SetAzimuthGear, axis);
}

[[nodiscard]] constexpr Action chooseTurnAction(Axis axis)
{
    return actionOf(Action::ChooseAzimuthTurn, axis);
}

// Copies share their reasons, because each status has a copy.
class Permissions
{
public:
    // Nothing is allowed: the state before the gates were asked.
    Permissions();
    // Everything is allowed, but fastestJog is 0: the state from which the gates refuse actions.
    [[nodiscard]] static Permissions all() { return Permissions(QString()); }

    // Why the action is refused; empty: it is allowed.
    [[nodiscard]] const QString& reason(Action action) const
    {
        return m_reasons ? m_reasons->of[static_cast<std::size_t>(action)] : m_ofAll;
    }
    [[nodiscard]] bool allows(Action action) const { return reason(action).isEmpty(); }
    // An empty reason changes nothing.
    void refuse(Action action, const QString& why);

    // The fastest jog by hand. It is lower while the wrap of an axis is unknown or the directions are unconfirmed.
    AngularRate fastestJog;

private:
    struct Reasons : QSharedData
    {
        std::array<QString, static_cast<std::size_t>(Action::Count)> of;
    };

    explicit Permissions(const QString& why) : m_ofAll(why) {}

    QString m_ofAll;  // while there is no reason of one action
    QSharedDataPointer<Reasons> m_reasons;
};

}  // namespace boresight

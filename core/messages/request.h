// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/messages/drive_gains.h"
#include "core/messages/tuning_status.h"
#include "core/profile/profile.h"
#include "core/targets/target.h"
#include "core/units/sky.h"

#include <QMetaType>
#include <QString>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

// Everything anybody may ask of the station, as values: they cross threads by queued signals. The station accepts or
// refuses each with a reason; the effect is seen in the next status.
namespace boresight::request {

struct PointSky  // go to a direction, the nearest permitted turn
{
    SkyPointing direction;
};
struct PointAxes  // go to mechanical angles: chooses the turn
{
    AxisPosition position;
    QString purpose = {};  // is shown and logged. Empty: it is a go-to
};
struct PointAxis  // go to this azimuth or elevation of a direction; the other axis stays where it is
{
    Axis axis = Axis::Azimuth;
    Angle angle;
};
struct JudgeDirection  // asks whether PointSky would be refused: see Answer::verdict. Moves nothing
{
    SkyPointing direction;
};
struct Jog  // dead-man: must be repeated within kJogKeepAlive, else the axes stop; zero rates end it
{
    AxisRates rates;
};
struct Move  // runs until Hold, a limit, or the end of the client that asked
{
    AxisRates rates;
    QString purpose = {};  // is shown and logged. Empty: a client moves the mount
};
struct Step  // move by a fixed amount from the present target
{
    Angle azimuth;
    Angle elevation;
};
struct Follow  // one point of the operator's own stream: what is followed is there now
{
    SkyPointing direction;
    QString what;       // "Sun"
    bool anew = false;  // the points before say nothing about this one
};
struct Track  // go to where it rises, follow it until it sets, then hold; stay where it does neither
{
    targets::Target target;
};
struct TrackFile  // the same with the table of a file, once the station has read it. Answered then
{
    QString path;  // absolute
};
struct FollowAzel  // keep the beam on the Moon of WSJT-X's azel.dat; below the horizon the mount is parked
{};
struct FollowPosition  // keep the beam on what reports its position
{};
struct FollowRotator  // point where another rotator points, once the station knows where that is. Answered then
{
    QString name;  // "rotctld:10.0.0.7:4533"
};
struct Nudge  // while a stream is followed: shifts it, see StationStatus::trim; else as Step
{
    Angle azimuth;
    Angle elevation;
};
struct ClearTrim
{};
struct Horizon  // elevation 0°, or the lowest permitted, at the present azimuth or at this one
{
    std::optional<Angle> azimuth;
};
struct UseAntenna  // all directions are those of its beam from now on. Moves what Boresight tracks itself, and nothing
                   // else
{
    std::string name;  // "main", or one of the profile
};
struct OverrideWind  // the mount may move in a strong wind, for the time of the profile. Moves nothing
{};
struct Hold  // decelerate and hold; not latched
{};
struct Stop  // decelerate and hold, latched until ResetStop
{};
struct ResetStop
{};
struct Park
{};
struct Home  // azimuth 0°, elevation at its lower limit or 0°
{};
struct Unwind  // the same direction, on the turn where the azimuth cable is wound least
{};
struct HoldAtEnd  // what is tracked keeps its wrap: at the end of the cable the mount waits until the target comes back
{};
struct Trial  // of a tuning run: dead-man like Jog, repeated in every tick; zero rates rest
{
    AxisRates rates;
};
struct Rearm  // clears a drive fault or time-out; the mount then stands in STANDBY
{};
struct TakeAuthority  // clients' motion is refused until GiveAuthority
{};
struct GiveAuthority
{};
struct GiveControl  // this client moves the mount from now on, and the operator gives control back
{
    std::uint64_t clientId = 0;
};
struct SetReadOnly  // its motion commands are refused
{
    std::uint64_t clientId = 0;
    bool readOnly = true;
};
struct Disconnect
{
    std::uint64_t clientId = 0;
};
struct AcknowledgeAlarms
{};
struct AcknowledgeAlarm
{
    std::uint64_t alarmId = 0;
};
struct ApplyProfile  // what applies now is in force with the next tick; the rest waits for Reconnect
{
    profile::Profile profile;
};
struct Reconnect  // decelerate, leave the drives as on_exit says, begin again with this profile
{
    profile::Profile profile;
};
struct ReadDrives  // scan, identify, read the drives' protections again
{};
struct FixDrives  // write the protections that differ; the drives must be switched off
{};
struct AssignBoard  // the only board on the bus gets the id of this axis: set, read back, stored
{
    QString board;  // its UUID, as the operator has confirmed it; empty: it tells none
    Axis axis = Axis::Azimuth;
};
struct SetGear  // the ratio of the profile is written into the drive of this axis: set, read back, stored
{
    Axis axis = Axis::Azimuth;
};
struct SwitchOff  // the drives off: an unbalanced elevation falls. Also the answer to "how do I let go"
{
    std::optional<Axis> axis{};  // this one alone, and the other goes on holding
};
struct ReleaseBus  // leave the adapter to other tools
{};
struct TakeBus
{};
struct ChooseTurn  // the operator has looked: the axis stands at this angle
{
    Axis axis = Axis::Azimuth;
    Angle angle;
};
struct ProveCrashStop  // move each axis at `rate`, really stop feeding its drive, measure
{
    AngularRate rate;
};
struct EndProof
{};
struct ReadGains
{
    Axis axis = Axis::Azimuth;
};
struct SetGain  // in force at once, until the drive loses its power; the axis stands
{
    Axis axis = Axis::Azimuth;
    Gain gain = Gain::Stiffness;
    double value = 0.0;
};
struct PutGainsBack  // as they were found first
{
    Axis axis = Axis::Azimuth;
};
struct StoreGains  // what is in force, for the next power-up; the drives are off
{
    Axis axis = Axis::Azimuth;
};

// Those of the tuning desk; only the operator may ask them. What they find out is in StationStatus::tuning.
struct StartTuning
{
    Axis axis = Axis::Azimuth;
    TuningRun run = TuningRun::Step;
};
struct EndTuning  // the run ends without a result, the mount holds
{};

// Those of the calibration desk; only the operator may ask them. What they find out is in StationStatus::calibration.
struct FollowBody  // keep the beam on it; Nudge trims. Ends by Hold, or any other motion
{
    ephemeris::Body body = ephemeris::Body::Sun;
    ephemeris::Refraction refraction = ephemeris::Refraction::Light;
    bool overTheTop = false;  // past the zenith, from the other side: tells the collimation from the azimuth's offset
};
struct TakePoint  // the body that was chosen last is centred now
{};
struct TakeKnownPoint  // something whose direction is known is centred now: a landmark
{
    SkyPointing truth;
    QString label;
};
struct DropPoint
{
    std::size_t index = 0;
};
struct UsePoint  // a point may stay in the list and be left out of the fit
{
    std::size_t index = 0;
    bool used = true;
};
struct DropAllPoints
{};
struct MeasureSensorOffset  // the mount stands still, the sensor is averaged
{};
struct PlanSwing  // only tells where it would turn, and how long
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;  // stops each way; 0: a sweep each way
};
struct StartSwing
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;
};
struct StartCrossScan  // across a body that is followed; wants the power at each place: GivePower
{
    Angle width;
    ephemeris::Body body = ephemeris::Body::Sun;
};
struct GivePower
{
    double decibels = 0.0;
};
struct ProposeTerms  // all of them, as typed: what is proposed from now on
{
    pointing::PointingTerms terms;
};
struct ImportTerms  // the same from a text of core/calibration/terms_text.h
{
    QString name;  // of the file
    std::string text;
};
struct EndCalibration  // the run ends without a result, the mount holds
{};
struct ApplyCalibration
{
    std::uint64_t proposal = 0;  // CalibrationProposal::number
};
struct DiscardCalibration  // what is proposed; the points stay
{
    std::uint64_t proposal = 0;
};
struct UndoCalibration
{};
struct RedoCalibration
{};

// Those of the schedule. What it does is in StationStatus::schedule.
struct ArmSchedule  // the mount tracks its passes, until somebody does anything else with it. Takes control
{};
struct DisarmSchedule  // what it moves ends, and the mount holds
{};
struct Rehearse  // the schedule, ahead of time, on a copy of the mount: StationStatus::rehearsal. Moves nothing
{
    bool on = true;  // else the rehearsal that runs ends without a result
};

}  // namespace boresight::request

namespace boresight {

using CalibrationRequest =
    std::variant<request::FollowBody, request::TakePoint, request::TakeKnownPoint, request::DropPoint,
                 request::UsePoint, request::DropAllPoints, request::MeasureSensorOffset, request::PlanSwing,
                 request::StartSwing, request::StartCrossScan, request::GivePower, request::ProposeTerms,
                 request::ImportTerms, request::EndCalibration, request::ApplyCalibration, request::DiscardCalibration,
                 request::UndoCalibration, request::RedoCalibration>;

using TuningRequest = std::variant<request::StartTuning, request::EndTuning>;

using ScheduleRequest = std::variant<request::ArmSchedule, request::DisarmSchedule>;

using AnyRequest =
    std::variant<request::PointSky, request::PointAxes, request::PointAxis, request::JudgeDirection, request::Jog,
                 request::Move, request::Step, request::Follow, request::Track, request::Nudge, request::ClearTrim,
                 request::Horizon, request::Hold, request::Stop, request::ResetStop, request::Park, request::Home,
                 request::Unwind, request::HoldAtEnd, request::Rearm, request::TakeAuthority, request::GiveAuthority,
                 request::GiveControl, request::SetReadOnly, request::Disconnect, request::AcknowledgeAlarms,
                 request::AcknowledgeAlarm, request::ApplyProfile, request::Reconnect, request::ReadDrives,
                 request::FixDrives, request::AssignBoard, request::SetGear, request::SwitchOff, request::ReleaseBus,
                 request::TakeBus, request::ChooseTurn, request::ProveCrashStop, request::EndProof, request::ReadGains,
                 request::SetGain, request::PutGainsBack, request::StoreGains, request::Trial, request::FollowAzel,
                 request::FollowPosition, request::FollowRotator, request::Rehearse, request::TrackFile,
                 request::UseAntenna, request::OverrideWind, TuningRequest, CalibrationRequest, ScheduleRequest>;

// Every source that includes this header would compile the copying of so many alternatives again. It is compiled once.
struct Request : AnyRequest
{
    using AnyRequest::AnyRequest;
    Request(const Request& other);
    Request(Request&& other) noexcept;
    Request& operator=(const Request& other);
    Request& operator=(Request&& other) noexcept;
    ~Request();
};

// A request of the screen, numbered so that the answer finds the control that sent it.
struct NumberedRequest
{
    std::uint64_t id = 0;
    Request request;
};

// A held jog control repeats Jog every kJogRepeat; the station stops the axes kJogKeepAlive after the last one.
inline constexpr std::chrono::milliseconds kJogRepeat{50};
inline constexpr std::chrono::milliseconds kJogKeepAlive{200};

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::NumberedRequest)

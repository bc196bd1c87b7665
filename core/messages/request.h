// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/messages/drive_gains.h"
#include "core/messages/tuning_status.h"
#include "core/plan/pass_plan.h"
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

// All requests to the station, as values: they cross threads by queued signals. The station accepts each one, or
// refuses it with a reason. The effect is visible in the next status.
namespace boresight::request {

struct PointSky  // go to a direction, on the nearest permitted wrap
{
    SkyPointing direction;
};
struct PointAxes  // go to mechanical angles, which also determine the wrap
{
    AxisPosition position;
    QString purpose = {};  // for the screen and the log. Empty: a go-to
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
struct JogThirdAxis  // dead-man, as Jog; a zero rate ends it
{
    AngularRate rate;
};
struct Move  // runs until Hold, a limit, or the end of the client that asked
{
    AxisRates rates;
    QString purpose = {};  // for the screen and the log. Empty: a client moves the mount
};
struct Step  // move by a fixed amount from the present target
{
    Angle azimuth;
    Angle elevation;
};
struct Follow  // one point of the stream of a calibration: the present direction of the Sun or the Moon
{
    SkyPointing direction;
    QString what;       // "Sun"
    bool anew = false;  // the stream begins again: earlier points must not be used to predict this one
};
struct Track  // wait where the target rises, follow it until it sets, then hold. A fixed target: go there and stay
{
    targets::Target target;
    std::optional<plan::ChosenWay> way = {};  // through the pass; empty: the best one
};
struct TrackFile  // the same with the table of a file. The answer comes after the station has read the file
{
    QString path;  // absolute
};
struct TrackForClient  // the answer to an offer: track the target of this client from Boresight's own orbit, or do not
{
    std::uint64_t clientId = 0;
    QString target;        // the name in the offer
    bool isWanted = true;  // false: the target is not offered to this client again
};
struct FollowAzel  // track the Moon by azel.dat of WSJT-X; while the Moon is below the horizon the mount is parked
{};
struct FollowPosition  // keep the beam on the balloon or rocket that reports its position
{};
struct FollowRotator  // point where another rotator points. The answer comes after its position was received
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
struct UseAntenna  // from then on all directions are those of the beam of this antenna. The mount moves only if
                   // Boresight tracks a target itself
{
    std::string name;  // "main", or the name of an antenna in the profile
};
struct OverrideWind  // the mount may move in a strong wind, for the time in the profile. Moves nothing
{};
struct UseNewTime  // the clock of this computer was set: point by its time, see ClockStatus::ahead
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
struct Unwind  // the same direction, on the wrap where the azimuth cable is wound least
{};
struct HoldAtEnd  // tracking keeps its wrap: at the end of the cable the mount waits until the target comes back
{};
struct Trial  // from a tuning run: dead-man like Jog, repeated in every tick; zero rates mean standing still
{
    AxisRates rates;
};
struct Rearm  // clears a drive fault or time-out; the mount then stands in STANDBY
{};
struct TakeAuthority  // motion commands of clients are refused until GiveAuthority
{};
struct GiveAuthority
{};
struct GiveControl  // the operator hands control to the clients, and this client becomes the active one
{
    std::uint64_t clientId = 0;
};
struct SetReadOnly  // motion commands of this client are refused
{
    std::uint64_t clientId = 0;
    bool readOnly = true;
};
struct Disconnect
{
    std::uint64_t clientId = 0;
};
struct LogProtocol  // begin or end the protocol log: StationUpdate::protocol
{
    bool on = true;
};
struct AcknowledgeAlarms
{};
struct AcknowledgeAlarm
{
    std::uint64_t alarmId = 0;
};
struct ApplyProfile  // settings that apply at once are in force with the next tick; the others wait for Reconnect
{
    profile::Profile profile;
};
struct Reconnect  // decelerate, leave the drives as on_exit says, begin again with this profile
{
    profile::Profile profile;
};
struct ReadDrives  // scan the bus, identify the drives, and read their safety settings again
{};
struct FixDrives  // write the safety settings that differ; the drives must be switched off
{};
struct AssignBoard  // the only board on the bus gets the id of this axis: set, read back, stored
{
    QString board;  // its UUID, as the operator has confirmed it; empty: the board reports none
    Axis axis = Axis::Azimuth;
};
struct SetGear  // the ratio of the profile is written into the drive of this axis: set, read back, stored
{
    Axis axis = Axis::Azimuth;
};
struct SwitchOff  // switch the drives off, so that the axes turn freely: an unbalanced elevation falls
{
    std::optional<Axis> axis{};  // only this axis, and the other one continues to hold; empty: both
};
struct ReleaseBus  // leave the adapter to other tools
{};
struct TakeBus
{};
struct TypeLine  // send this line to the control box as it is; the answer is in StationStatus::console
{
    std::string line;
};
struct MakeHomeRun  // the rotator drives to its own switches and counts from there again; no limit holds meanwhile
{};
struct ChooseTurn  // the operator has looked at the mount: the axis stands at this angle
{
    Axis axis = Axis::Azimuth;
    Angle angle;
};
struct ProveCrashStop  // move each axis at `rate`, really stop the commands to its drive, and measure the stop
{
    AngularRate rate;
};
struct EndProof
{};
struct ReadGains
{
    Axis axis = Axis::Azimuth;
};
struct SetGain  // in force at once, until the drive loses its power; the axis must stand still
{
    Axis axis = Axis::Azimuth;
    Gain gain = Gain::Stiffness;
    double value = 0.0;
};
struct PutGainsBack  // restore the gains as they were first read
{
    Axis axis = Axis::Azimuth;
};
struct StoreGains  // store the gains in force for the next power-up; the drives must be off
{
    Axis axis = Axis::Azimuth;
};

// Requests to the tuning desk. Only the operator may send them. The results are in StationStatus::tuning.
struct StartTuning
{
    Axis axis = Axis::Azimuth;
    TuningRun run = TuningRun::Step;
};
struct EndTuning  // the run ends without a result, the mount holds
{};

// Requests to the calibration desk. Only the operator may send them. The results are in StationStatus::calibration.
struct FollowBody  // keep the beam on the body; Nudge changes the trim. Hold or any other motion ends it
{
    ephemeris::Body body = ephemeris::Body::Sun;
    ephemeris::Refraction refraction = ephemeris::Refraction::Light;
    bool overTheTop = false;  // past the zenith, which separates the collimation from the azimuth offset
};
struct TakePoint  // the body that was followed last is centred in the beam now
{};
struct TakeKnownPoint  // an object of known direction, such as a landmark, is centred in the beam now
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
struct MeasureSensorOffset  // average the sensor while the mount stands still
{};
struct PlanSwing  // only reports where a swing would turn the mount and how long it would take
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;  // stops each way; 0: a sweep each way
};
struct StartSwing
{
    AngularRate rate = AngularRate::fromDegrees(3.0);
    int headings = 0;
};
struct StartCrossScan  // scan across the followed body; at each place the scan needs the power (GivePower)
{
    Angle width;
    ephemeris::Body body = ephemeris::Body::Sun;
};
struct GivePower
{
    double decibels = 0.0;
};
struct ProposeTerms  // propose these terms, all of them as typed
{
    pointing::PointingTerms terms;
};
struct ImportTerms  // propose the terms in a text of the form of core/calibration/terms_text.h
{
    QString name;  // name of the file
    std::string text;
};
struct EndCalibration  // the run ends without a result, the mount holds
{};
struct ApplyCalibration
{
    std::uint64_t proposal = 0;    // CalibrationProposal::number
    bool overridesDoubts = false;  // the operator applies an unreliable result anyway: CalibrationProposal::doubts
};
struct DiscardCalibration  // drop the proposal; the points stay
{
    std::uint64_t proposal = 0;
};
struct UndoCalibration
{};
struct RedoCalibration
{};

// Requests to the schedule. Its state is in StationStatus::schedule.
struct ArmSchedule  // the mount tracks the passes until any other motion is requested. Takes control
{};
struct DisarmSchedule  // the motion of the schedule ends, and the mount holds
{};
struct Rehearse  // run the schedule ahead of time on a simulated copy: StationStatus::rehearsal. Moves nothing
{
    bool on = true;  // false: the running rehearsal ends without a result
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
                 request::TypeLine, request::MakeHomeRun, request::SetGain, request::PutGainsBack, request::StoreGains,
                 request::Trial, request::FollowAzel, request::FollowPosition, request::FollowRotator,
                 request::TrackForClient, request::Rehearse, request::TrackFile, request::UseAntenna,
                 request::OverrideWind, request::UseNewTime, request::JogThirdAxis, request::LogProtocol, TuningRequest,
                 CalibrationRequest, ScheduleRequest>;

// Copying so many alternatives is compiled once in request.cpp, and not in every source that includes this header.
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

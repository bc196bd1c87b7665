// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/budget/error_budget.h"
#include "core/elements/element_set.h"
#include "core/ephemeris/almanac.h"
#include "core/messages/azel_status.h"
#include "core/messages/brake_status.h"
#include "core/messages/calibration_status.h"
#include "core/messages/capabilities.h"
#include "core/messages/drives_status.h"
#include "core/messages/end_switch_status.h"
#include "core/messages/motor_starts.h"
#include "core/messages/mount_line.h"
#include "core/messages/permissions.h"
#include "core/messages/position_status.h"
#include "core/messages/power_status.h"
#include "core/messages/recognised_target.h"
#include "core/messages/rehearsal_status.h"
#include "core/messages/schedule_status.h"
#include "core/messages/sensor_status.h"
#include "core/messages/third_axis_status.h"
#include "core/messages/transmit_status.h"
#include "core/messages/tuning_status.h"
#include "core/messages/wind_status.h"
#include "core/plan/pass_plan.h"
#include "core/profile/profile.h"
#include "core/targets/sky_moment.h"
#include "core/units/sky.h"

#include <QMetaType>
#include <QString>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// What the station reports: plain values, made on the station thread once per update. The screen, the clients and the
// tests read them and compute no pointing from them. An unknown value is an empty optional. Angles of an axis are
// mechanical (unwrapped). `SkyPointing` values are directions.
namespace boresight {

struct ProtocolLine;  // protocol_line.h

// A default value. All statuses share one object, because a status is made many times a second.
template <class T>
[[nodiscard]] std::shared_ptr<const T> fresh()
{
    static const auto one = std::make_shared<const T>();
    return one;
}

enum class StationState
{
    Disconnected,  // no bus, or a drive does not answer
    Standby,       // connected; nothing commanded since start, reconnect, fault or reset of STOP
    Hold,          // holding a position
    Slew,          // on the way to a fixed target
    Track,         // following a stream of targets
    Jog,           // moving while a key, button or `M` command is held
    Parked,        // holding the park position
    Calibrate,     // a calibration run moves the mount
    Stopped,       // STOP is latched
    Fault,         // a drive is in fault, timed out or silent: explicit re-arm needed
};

enum class AxisState
{
    NoData,
    Holding,
    Moving,
    Limit,
    Stopped,
    Fault,
    On,  // switched on, but not following set-points from Boresight
    Off,
    Missing  // the mount has no such axis
};

enum class Severity
{
    Advisory,
    Warning,
    Alarm
};

// The tracked path leads beyond an end of the azimuth range.
struct CableEnd
{
    Angle end;
    Seconds in;
    // The time to turn back by 360° and continue. Empty: there is no other wrap, and the mount waits at the end.
    std::optional<Seconds> turningBack;
    // How long the target is lost if the mount waits at the end instead of turning back. Empty: there is no such
    // choice, or the way of the target is unknown.
    std::optional<Seconds> lostByHolding = {};
};

// Whether the clients or the operator may move the mount.
enum class Authority
{
    Clients,
    Operator
};

enum class SourceKind
{
    Operator,
    Client,
    Station
};

// The sender of a request. The log and the screen show `name`: "operator", "rotctld 127.0.0.1:51234". A client that
// speaks another protocol is "client PROTOCOL ADDRESS".
struct Source
{
    SourceKind kind = SourceKind::Station;
    std::uint64_t clientId = 0;
    QString name;

    bool operator==(const Source&) const = default;
};

// Where the beam points, as the angle that belongs to an axis: the true azimuth, unwrapped like the axis, or the true
// elevation, which is above 90° over the top.
struct BeamAngles
{
    std::optional<Angle> actual;
    std::optional<Angle> commanded;
    std::optional<Angle> target;
};

struct AxisStatus
{
    AxisState state = AxisState::NoData;
    std::optional<Angle> actual;                   // last measured, of any age
    std::optional<AngularRate> rate;               // last measured
    std::optional<std::chrono::milliseconds> age;  // of `actual`, or else of the last reply; empty: no reply yet
    std::optional<Angle> commanded;                // the set-point sent now
    std::optional<AngularRate> commandedRate;      // of the set-point
    std::optional<Angle> target;                   // where the set-point is moving to
    TravelRange travel;
    BeamAngles beam;                         // of the beam
    std::optional<double> busVoltage;        // V
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C, empty without a sensor
    std::optional<double> torque;            // Nm
    std::optional<double> current;           // A, q axis
    std::optional<double> power;             // W, electrical
    std::optional<MotorStarts> starts;       // of a motor that is only switched on and off
    bool turnKnown = false;                  // whether the wrap of the axis is known
    QString stateText;                       // e.g. "at travel limit 450.0°"; may be empty
};

struct ClientStatus
{
    std::uint64_t id = 0;
    QString address;
    QString program;                 // the recognised program, else the protocol if it is not rotctld
    QString lastCommand;             // why it was refused, or what became of its target
    double commandsPerSecond = 0.0;  // over the last seconds
    std::uint64_t oddCommands = 0;   // unknown, unreadable, or for something the mount does not have
    bool driving = false;            // the mount follows its target now
    bool inControl = false;          // its motion commands are accepted, other clients' are not
    bool readOnly = false;
    bool locked = false;      // the profile names this client as the only one that may move the mount
    bool wanting = false;     // requests control: its motion commands are refused because another client has it
    QString advice;           // what would make the client work better; may be empty
    QString controlObstacle;  // why control cannot or need not be given to it now; empty: it can be given
};

// The MQTT broker, if it is needed: for the sensor, or to publish the state of the station.
struct BrokerStatus
{
    bool wanted = false;
    bool connected = false;
    QString name;                    // "broker.example:1883"
    QString problem;                 // one line: what, where, what to do; empty: no problem
    std::optional<Seconds> retryIn;  // empty while there is a connection or an attempt at one
};

// The button that an alarm offers, if any. The panel that shows the alarm knows the request behind the button.
enum class AlarmHelp
{
    None,
    Rearm,
    ResetStop,
    Unwind,
    HoldAtEnd,
    Reconnect,
    ParkNow,
    OverrideWind,
    UseNewTime,
    MovePark,
    OpenProtection,
    OpenDrives,
    OpenClients,
    OpenLimits,
    OpenNorth,
    OpenProfile,
    ConfirmWrap,
    OpenHomeRun,
    OpenGuide,  // its step Connect
};

struct Alarm
{
    std::uint64_t id = 0;
    QString name = {};   // its id in the catalogue, never translated: "drive.silent"
    QString about = {};  // "azimuth"; empty: the station
    Severity severity = Severity::Warning;
    QString what = {};    // what happened
    QString action = {};  // what Boresight did
    QString remedy = {};  // what to do
    AlarmHelp help = AlarmHelp::None;
    UtcTime since = {};
    bool active = true;
    bool acknowledged = false;
};

// How far the mount is on its way to a fixed target.
struct SlewProgress
{
    Seconds remaining{0.0};
    double done = 0.0;  // 0 to 1 of the time that the whole way takes
};

// The target that the station tracks by itself, or for whose rise it waits: a satellite, a body, a direction, a
// position.
struct TrackedTarget
{
    QString name;
    std::optional<std::int64_t> number = {};  // of a satellite
    bool isUp = false;
    std::optional<UtcTime> next = {};  // the next set or rise; empty: it never sets
    // From its rise, or from when it was selected, until it sets, but at most for a day. Null: unknown.
    targets::SkyWay way = {};
    // How the mount will drive the pass, and the error to expect. Null: not planned, or not yet.
    plan::SharedVariant plan = {};
    // The angular rate across the sky now, or at the rise. If the clock is wrong by 1 s, the beam is wrong by the angle
    // that the target moves in 1 s. Empty: the direction does not depend on the clock of this computer.
    std::optional<AngularRate> skyRate = {};
};

// The direction of a body in the sky of the site, also below the horizon.
struct BodyPlace
{
    ephemeris::Body body = ephemeris::Body::Sun;
    SkyPointing direction;
};

// How late the control ticks have come since the start, and how the operating system schedules them.
struct TimingStatus
{
    Seconds lateP50{0.0};
    Seconds lateP99{0.0};
    Seconds lateWorst{0.0};
    QString scheduling;  // one line; empty: nobody has requested real-time scheduling
};

// The clock of this computer. Satellites, Sun and Moon are computed with it.
struct ClockStatus
{
    bool synchronised = true;      // a time source sets it
    std::optional<Seconds> error;  // as reported by the time source
    // The clock was set by this, and Boresight still points by the old time. Empty: it points by the clock.
    std::optional<Seconds> ahead = {};
};

struct StationStatus
{
    StationState state = StationState::Disconnected;
    QString stateReason;       // one line: why it is in this state, for the tool tip and the log
    bool stopLatched = false;  // also while the state is DISCONNECTED or FAULT
    AxisStatus azimuth;
    AxisStatus elevation;
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    QString targetText;     // "P 339.50 57.00", "go to 113.0° 10.0°", "park"; empty: no target
    Source commander;       // the source of the target
    bool aimed = false;     // the target is a direction, not a jog, a place of the mount itself or a calibration
    bool limited = false;   // the target is outside the limits, and the mount goes to the nearest permitted place
    QString limitedReason;  // why it is limited: "elevation -5.0° below limit 0.0°"
    std::vector<SkyPointing> route;    // the beam goes around forbidden places, from `commanded` to the target
    std::optional<SlewProgress> slew;  // empty: the mount is not on its way to a fixed target
    std::optional<SkyPointing> trim;   // the sum of the operator's nudges, added to each point of a stream
    // The parts of the pointing error. Empty: no direction is aimed at, or the measured position is old.
    std::optional<budget::ErrorBudget> errorBudget;
    std::optional<CableEnd> cableEnd;  // reported at least 30° or 30 s ahead, and while the mount waits there
    Authority authority = Authority::Clients;
    // The operator took control by something other than "Take control", and clients have not got it back since.
    bool tookControl = false;
    std::optional<TrackedTarget> tracked;
    std::optional<RecognisedTarget> clientTarget;  // of the client in control; empty: not recognised, or not offered
    std::string antenna = pointing::kMainAntenna;  // name of the antenna in use: see antennaOf()
    std::string chosenAntenna = pointing::kMainAntenna;  // by the operator, for targets without one of their own
    // Satellites with known elements, sorted by number. Never null.
    std::shared_ptr<const std::vector<orbit::ElementSet>> satellites =
        std::make_shared<const std::vector<orbit::ElementSet>>();
    QStringList elementProblems;  // the first problems of element files and downloads
    AzelStatus azel;
    PositionStatus position;
    WindStatus wind;
    std::vector<BodyPlace> bodies;             // empty: the site is unknown
    Permissions permissions;                   // of the operator
    Capabilities capabilities;                 // of the mount
    std::optional<DrivesStatus> drives;        // empty: the drives cannot be read or set
    std::optional<ThirdAxisStatus> thirdAxis;  // empty: the mount has none
    MountLine line;
    // The lines that were typed to the control box, each after "> ", with the answers, oldest first. Empty: the mount
    // takes no typed lines.
    std::optional<QStringList> console;
    bool simulated = false;
    QString listening;  // "127.0.0.1:4533", empty when the server could not listen
    std::vector<ClientStatus> clients;
    bool isProtocolLogged = false;  // the protocol log is on
    PowerStatus power;
    TimingStatus timing;
    BrokerStatus broker;
    SensorStatus sensor;
    std::vector<Alarm> alarms;  // active or unacknowledged, worst first
    UtcTime utc;                // by which the mount is pointed
    std::uint64_t tick = 0;
    // The profile in force. The screen draws and edits the same object that the station obeys. Never null.
    std::shared_ptr<const profile::Profile> profile = fresh<profile::Profile>();
    std::vector<pointing::KeepOut> sunKeepOuts;  // added to the keep-outs of the profile while the Sun is up
    std::vector<std::string> waitingKeys;        // settings that apply after Reconnect
    // The state and the results of the calibrations. Never null.
    std::shared_ptr<const CalibrationStatus> calibration = fresh<CalibrationStatus>();
    // The state and the results of tuning. Never null.
    std::shared_ptr<const TuningStatus> tuning = fresh<TuningStatus>();
    // The passes that Boresight tracks by itself. Never null.
    std::shared_ptr<const ScheduleStatus> schedule = fresh<ScheduleStatus>();
    RehearsalStatus rehearsal;
    TransmitStatus transmit;
    BrakeStatus brake;
    std::vector<EndSwitchStatus> endSwitches;  // of the profile
    ClockStatus clock;
};

// The clock of the computer of the station. Alarms and lines of the log have this time. It differs from `utc` only
// while the station uses an old time, after its clock was set.
[[nodiscard]] inline UtcTime computerUtc(const StationStatus& status)
{
    return status.utc + std::chrono::round<UtcTime::duration>(status.clock.ahead.value_or(Seconds(0.0)));
}
// The antenna in use. Directions in the status are those of its beam, and its beam width shows how much a pointing
// error matters.
[[nodiscard]] inline pointing::Antenna antennaOf(const StationStatus& status)
{
    return status.profile->antenna(status.antenna);
}
// How the beam in use differs from what the axes show.
[[nodiscard]] inline pointing::PointingTerms termsOf(const StationStatus& status)
{
    return status.profile->termsOf(antennaOf(status));
}

// The values of an axis in one tick, for the charts. Empty: unknown.
struct AxisSample
{
    std::optional<Angle> commanded;
    std::optional<Angle> actual;
    std::optional<double> torque;            // Nm
    std::optional<double> current;           // A, q axis
    std::optional<double> busVoltage;        // V
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C
};

struct TickSample
{
    SteadyTime time;
    std::array<AxisSample, 2> axes;  // azimuth, elevation
};

// The kind of event that a line of the log reports.
enum class LogKind
{
    Event,
    MotionStart,  // which source moved the mount, and why
    Alarm
};

// The alarm that a line of the log belongs to.
struct LoggedAlarm
{
    QString name = {};   // its id in the catalogue; empty: no alarm
    QString about = {};  // as of Alarm

    bool operator==(const LoggedAlarm&) const = default;
};

struct LogEntry
{
    std::uint64_t number = 0;  // counts up by one
    UtcTime utc;
    Severity severity = Severity::Advisory;
    QString source;  // "operator", "rotctld 127.0.0.1:51234", "station", "azimuth drive", "bus"
    QString text;
    LogKind kind = LogKind::Event;
    LoggedAlarm alarm = {};
};

// Whether the mount may be sent to a direction. It judges the direction only: reasons against any motion are in the
// permissions.
struct DirectionVerdict
{
    QString whyNot = {};                      // empty: it may
    std::optional<SkyPointing> nearest = {};  // the nearest permitted direction, if this one is not permitted

    bool operator==(const DirectionVerdict&) const = default;
};

// The answer to one request of the screen. An empty `error` means that the request was accepted.
struct Answer
{
    std::uint64_t requestId = 0;
    std::optional<Error> error = {};
    std::optional<DirectionVerdict> verdict = {};  // of JudgeDirection
};

// One update for the screen. The station sends the next one only after the last one was taken. So a stalled screen gets
// the newest status and a limited part of the log, and no queue grows.
struct StationUpdate
{
    StationStatus status;
    std::vector<LogEntry> log;
    std::vector<Answer> answers;
    std::vector<TickSample> samples;  // of the ticks since the last update; if there were too many, only the newest
    std::shared_ptr<const std::vector<ProtocolLine>> protocol = {};  // new lines of the protocol log; null: none
};

// The words of ui.md and of every log line: "TRACK", "NO DATA".
[[nodiscard]] QString word(StationState state);
[[nodiscard]] QString word(AxisState state);
// The source of a line of the log, in the language of the program.
[[nodiscard]] QString sourceText(const QString& source);

}  // namespace boresight

Q_DECLARE_METATYPE(boresight::StationStatus)
Q_DECLARE_METATYPE(boresight::StationUpdate)

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/elements/satellite_mark.h"
#include "core/ephemeris/refraction.h"
#include "core/pointing/antenna.h"
#include "core/pointing/mount_model.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/profile/axis_driver.h"
#include "core/profile/brake_settings.h"
#include "core/profile/client_lock.h"
#include "core/profile/end_switch_settings.h"
#include "core/profile/position_settings.h"
#include "core/profile/power_settings.h"
#include "core/profile/record_settings.h"
#include "core/profile/rotator_settings.h"
#include "core/profile/sensor_settings.h"
#include "core/profile/transmit_settings.h"
#include "core/profile/wind_settings.h"
#include "core/schedule/watch_entry.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/site.h"
#include "core/units/sky.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// All settings of one mount, as plain values. The initial values are the defaults and describe the reference mount:
// azimuth 0…360° is 0…1 turn. The elevation drive is mounted inverted: 0° is -0.25 turn, 90° is -0.5 turn. setting.h
// describes each key of the file, with unit and range. profile_file.h reads and writes the file.
namespace boresight::profile {

inline constexpr int kVersion = 1;

// Whether the position that a drive reports after its power-up can be trusted. A moteus without an encoder on the
// output knows its position only within one turn of the rotor (home state 1).
enum class PowerUpPosition
{
    Ambiguous,  // no absolute pointing until the drive reports a referenced output (home state 2)
    Trusted     // the position is right: the axis has an encoder, and its travel is below one turn of the encoder
};

// What the drive does by itself when its watchdog expires (servo.timeout_mode).
enum class TimeoutMode
{
    Hold,  // 10: brakes with its own limits, then holds
    Brake  // 15: shorts the phases; only a self-locking gearbox then stays where it is
};

struct AxisSettings
{
    AxisDriver driver = AxisDriver::Moteus;  // what turns the axis
    int id = 1;                              // of the moteus controller on the bus
    pointing::AxisGeometry geometry{};
    tracking::MotionLimits limits{};
    double stepsPerTurn = 0.0;  // the axis can stand only at these; 0: as its driver counts
    double maxTorque = 0.0;     // Nm, as the drive counts
    PowerUpPosition powerUpPosition = PowerUpPosition::Ambiguous;
    TimeoutMode timeoutMode = TimeoutMode::Hold;

    bool operator==(const AxisSettings&) const = default;
};

// What the drives do after the program has ended.
enum class OnExit
{
    Hold,
    Brake,
    Off
};

// What happens if a client sends a direction outside the permitted region.
enum class OutsideLimits
{
    Nearest,  // drive to the nearest permitted point and show AT LIMIT
    Refuse    // an error to the client, nothing moves
};

// How `p` reports the azimuth to a client.
enum class AzimuthConvention
{
    ZeroTo360,
    PlusMinus180,
    Continuous  // the unwrapped angle of the axis: 370° stays 370°
};

// Whether a person has confirmed that each axis turns as the profile sets. Before that, Boresight moves it only a
// little.
enum class Directions
{
    Confirmed,
    Unconfirmed
};
// The fastest motion while the directions are not confirmed.
inline constexpr AngularRate kFastestUnconfirmed = AngularRate::fromDegrees(5.0);

struct MountSettings
{
    std::string name = "Boresight mount";
    Angle beamWidth = Angle::fromDegrees(10.0);
    Directions directions = Directions::Confirmed;

    bool operator==(const MountSettings&) const = default;
};

// What happens after a short stall of this computer, in which the watchdogs stopped the drives.
enum class AfterStall
{
    Resume,  // the motion continues if nothing is in doubt
    Wait     // for a re-arm
};

// When the two axes arrive at the end of a slew.
enum class Arrival
{
    Separate,  // each as soon as it can
    Together   // the faster one is slowed
};

struct ControlSettings
{
    int tickHz = 50;
    Seconds watchdog{0.1};
    Arrival arrival = Arrival::Separate;
    AfterStall afterStall = AfterStall::Resume;
    OnExit onExit = OnExit::Hold;
    Angle driveLimitMargin = Angle::fromDegrees(3.0);  // how far the drives' own position bounds are beyond the travel

    [[nodiscard]] Seconds tickPeriod() const { return Seconds(1.0 / tickHz); }
    bool operator==(const ControlSettings&) const = default;
};

struct JogSettings
{
    AngularRate slow = AngularRate::fromDegrees(0.2);
    AngularRate normal = AngularRate::fromDegrees(2.0);
    AngularRate fast = AngularRate::fromDegrees(6.0);
    AngularRate unwind = AngularRate::fromDegrees(2.0);  // while the wrap of an axis is unknown

    bool operator==(const JogSettings&) const = default;
};

// The site of the mount. Nothing is computed from it unless `known` is true.
struct SiteSettings
{
    bool known = false;
    Angle latitude;   // north positive
    Angle longitude;  // east positive
    double heightMetres = 0.0;

    [[nodiscard]] Site place() const
    {
        return {.latitude = latitude, .longitude = longitude, .heightMetres = heightMetres};
    }

    bool operator==(const SiteSettings&) const = default;
};

// A Gpredict on this computer, whose stations and satellites Boresight reads.
struct GpredictSettings
{
    std::string folder;  // folder with its .qth files and satdata; empty: the usual folder of Gpredict

    bool operator==(const GpredictSettings&) const = default;
};

// Satellites that Boresight tracks by itself.
struct OrbitSettings
{
    std::vector<std::string> elements;  // files and folders; empty: those of Gpredict on this computer
    double oldestDays = 30.0;           // older elements may not be tracked
    Seconds lead{0.0};                  // how far the set-points are ahead, because the drives lag
    ephemeris::RefractionRule refraction = ephemeris::RefractionRule::ByKind;  // rule for targets that Boresight tracks

    bool operator==(const OrbitSettings&) const = default;
};

enum class OnlyWhileReceiving
{
    Off,
    On
};

// The Moon by the azel.dat of WSJT-X.
struct AzelSettings
{
    std::string file;           // empty: the usual place of WSJT-X for this user
    Seconds interval{1.0};      // time between two targets of the mount; at most 1 s: a new target in each tick
    double beamFraction = 0.0;  // the mount moves when the Moon has moved this part of the beam width; 0: always
    OnlyWhileReceiving onlyWhileReceiving = OnlyWhileReceiving::Off;

    bool operator==(const AzelSettings&) const = default;
};

// Whether the schedule is armed automatically after the start of the program.
enum class Unattended
{
    Off,  // a person arms it
    On    // as soon as the mount may be moved
};

// What the mount does between two passes of the schedule.
enum class BetweenPasses
{
    Hold,
    Unwind,
    Park
};

enum class ParkAfter
{
    Off,
    On  // if no pass follows within half an hour
};

// A program with its arguments, which runs at a moment of a pass. Empty: none.
using Command = std::vector<std::string>;

struct PassHooks
{
    Command beforeAos;
    Command aos;
    Command los;
    Command fault;
    Seconds before{60.0};  // beforeAos runs this long before AOS

    bool operator==(const PassHooks&) const = default;
};

// The passes that Boresight tracks by itself while the schedule is armed.
struct ScheduleSettings
{
    std::vector<schedule::WatchEntry> watch;
    schedule::OverlapPolicy policy = schedule::OverlapPolicy::Priority;
    Seconds lead{90.0};  // the mount is sent to the beginning of a pass this long before it
    BetweenPasses between = BetweenPasses::Unwind;
    ParkAfter parkAfter = ParkAfter::On;
    Unattended unattended = Unattended::Off;
    PassHooks hooks;

    bool operator==(const ScheduleSettings&) const = default;
};

// Whether the beam is kept away from the Sun. The Sun could melt the feed or drown the received signal.
enum class KeepAway
{
    Off,
    On  // the Sun is computed from the site and the computer's clock
};

// Whether the clock is good enough to compute the Sun.
enum class SunClock
{
    Synchronised,  // the clock is used only while a time source sets it
    Trusted        // the clock is always used, because the operator trusts it
};

struct SunSettings
{
    KeepAway keepAway = KeepAway::Off;
    SunClock clock = SunClock::Synchronised;
    Angle radius = Angle::fromDegrees(10.0);  // the beam stays farther than this from the Sun

    bool operator==(const SunSettings&) const = default;
};

// A direction with a name that the operator gave.
struct Preset
{
    std::string name;
    SkyPointing direction;

    bool operator==(const Preset&) const = default;
};

struct ListenAddress
{
    std::string host = "127.0.0.1";
    std::uint16_t port = 4533;  // 0: any free port

    bool operator==(const ListenAddress&) const = default;
};

// The answer to \dump_state, which a Hamlib client reads when it connects.
enum class DumpState
{
    OldAndNew,  // readable for Hamlib 4.0 and later
    AsHamlib    // byte for byte as Hamlib 4.5.1 and later; older clients then refuse every target
};

// Which of several clients moves the mount. Reading and stopping are open to all.
enum class ControlRule
{
    First,  // the first client keeps control until it has sent no motion command for 10 s, or disconnects
    Last,   // whoever sent the newest command, as Hamlib does
    Locked  // only the client at `lockedTo`
};

struct RotctldSettings
{
    ListenAddress listen;
    std::vector<std::string> allow;  // addresses and networks ("10.0.0.0/8"); empty: everybody who can reach the port
    ControlRule control = ControlRule::First;
    std::string lockedTo;  // the address of the one client that may move the mount, while `control` is Locked
    OutsideLimits outsideLimits = OutsideLimits::Nearest;
    AzimuthConvention azimuth = AzimuthConvention::ZeroTo360;
    DumpState dumpState = DumpState::OldAndNew;
    int maxClients = 600;

    bool operator==(const RotctldSettings&) const = default;
};

// The limits at which Boresight reports that an axis does not obey (core/supervision). `Hint` only reports, `Stop` also
// stops the mount.
struct SupervisionSettings
{
    Angle followingHint = Angle::fromDegrees(1.5);  // distance between set-point and axis that lasts for followingTime
    Angle followingStop = Angle::fromDegrees(3.0);
    Seconds followingTime{0.5};
    Seconds stallTime{0.8};                       // commanded to move, but stands still for this time
    Angle uncommanded = Angle::fromDegrees(1.0);  // moved by this angle although it should stand still
    Angle encoderJump = Angle::fromDegrees(0.5);  // change between two replies that the fastest motion does not explain
    Angle outsideHint = Angle::fromDegrees(0.5);  // beyond the travel
    Angle outsideStop = Angle::fromDegrees(1.5);  // beyond the travel and moving farther out
    Seconds replyAge{0.1};
    double supplyLow = 20.0;    // V
    double supplyStop = 12.0;   // V; stops while the drives still have enough voltage to brake
    double supplyHigh = 42.0;   // V
    double boardHot = 60.0;     // °C
    double boardLimit = 75.0;   // °C; the drive switches off here (fault 38)
    double motorHot = 80.0;     // °C
    Seconds trendAhead{300.0};  // warn when a trend reaches its limit within this time
    double torqueHint = 0.7;    // of the axis's maximum torque, for 2 s
    double torqueAtRest = 0.4;  // the same for a standing axis: more than weight and friction explain
    double torqueUnwind = 0.4;  // while the wrap is unknown or only entered: the cable may be pulled

    bool operator==(const SupervisionSettings&) const = default;
};

// Whether the mount is re-armed without a person after a loss whose cause has passed.
enum class Retry
{
    Never,
    Once,     // once per episode
    Interval  // again and again
};

struct RecoverySettings
{
    Retry overTemperature = Retry::Never;
    Retry supply = Retry::Never;
    Retry bus = Retry::Never;
    Seconds interval{60.0};  // time from the loss or the last attempt to the next attempt

    bool operator==(const RecoverySettings&) const = default;
};

enum class Tls
{
    Off,
    On
};

// Whether Boresight publishes its state at the broker.
enum class Publish
{
    Off,
    On
};

// The permitted commands by MQTT. Everyone who may write to the topics of the broker can send them.
enum class BrokerCommands
{
    Off,   // nothing: Boresight does not read the topics
    Stop,  // stop the mount and ask for its position
    Drive  // move it, too
};

// Whether Boresight describes itself to Home Assistant.
enum class HomeAssistant
{
    Off,
    On
};

// The MQTT broker that delivers the sensor's messages and receives those of Boresight.
struct BrokerSettings
{
    std::string host = "localhost";
    int port = 1883;
    std::string user;      // empty: without a user
    std::string password;  // plain text, as the broker needs it; never in logs or diagnostics
    Tls tls = Tls::Off;
    std::string caFile;    // PEM; empty: the certificate authorities of this computer
    std::string clientId;  // empty: a new one at each start
    Publish publish = Publish::Off;
    std::string prefix = "boresight/";
    BrokerCommands commands = BrokerCommands::Off;
    HomeAssistant homeAssistant = HomeAssistant::Off;
    std::string discoveryPrefix = "homeassistant";  // the prefix that is set in Home Assistant

    // For example "boresight/state". The prefix may end with a slash or not.
    [[nodiscard]] std::string topic(const std::string& name) const
    {
        return prefix.ends_with('/') ? prefix + name : prefix + "/" + name;
    }
    bool operator==(const BrokerSettings&) const = default;
};

[[nodiscard]] AxisSettings referenceAzimuth();
[[nodiscard]] AxisSettings referenceElevation();
[[nodiscard]] AxisSettings referenceThirdAxis();

// An axis beside the two, such as the polarisation. It is watched and jogged. It points nothing, so no client and no
// target moves it.
struct ThirdAxisSettings
{
    std::string name = "polarisation";
    AxisSettings axis = referenceThirdAxis();  // its id is 0 if there is none

    [[nodiscard]] bool isUsed() const { return axis.id != 0; }
    bool operator==(const ThirdAxisSettings&) const = default;
};

struct Profile
{
    MountSettings mount;
    std::string bus = "simulated";            // "fdcanusb:PATH", "socketcan:IFACE", "serial:PATH", "tcp:HOST:PORT"
    int baud = 9600;                          // speed of a serial bus
    std::vector<std::string> hamlibSettings;  // of Hamlib: "min_az=-90" (rotctl::HamlibSetting)
    std::vector<std::string> watchedBoards;   // boards that turn no axis: "3 polarisation" (WatchedBoard)
    AxisSettings azimuth = referenceAzimuth();
    AxisSettings elevation = referenceElevation();
    ThirdAxisSettings thirdAxis;
    RotatorSettings rotator;
    ControlSettings control;
    pointing::PointingTerms pointing;         // how the true direction differs from what the axes show
    std::vector<pointing::Antenna> antennas;  // in addition to the main antenna, which has the beam width of the mount
    pointing::Region limits;
    AxisPosition park{};     // mechanical angles
    double parkAfter = 0.0;  // min without a motion or a command; 0: the mount is never parked for this
    std::vector<Preset> presets;
    SiteSettings site;
    GpredictSettings gpredict;
    OrbitSettings orbit;
    orbit::SatelliteMarks satellites;  // favourites and notes of the operator
    AzelSettings azel;
    ClientLock clientLock = ClientLock::Ask;
    PositionSettings position;
    ScheduleSettings schedule;
    RecordSettings record;
    SunSettings sun;
    JogSettings jog;
    RotctldSettings rotctld;
    std::vector<std::string> listeners;  // for programs that do not use rotctld, see listeners::Listener
    SupervisionSettings supervision;
    RecoverySettings recovery;
    SensorSettings sensor;
    BrokerSettings mqtt;
    PowerSettings power;
    TransmitSettings transmit;
    BrakeSettings brake;
    EndSwitchSettings endSwitches;
    WindSettings wind;

    [[nodiscard]] const AxisSettings& axis(Axis which) const { return which == Axis::Azimuth ? azimuth : elevation; }
    // The axis that has no driver.
    [[nodiscard]] std::optional<Axis> missing() const
    {
        return azimuth.driver == AxisDriver::None     ? std::optional(Axis::Azimuth)
               : elevation.driver == AxisDriver::None ? std::optional(Axis::Elevation)
                                                      : std::nullopt;
    }
    // The antenna of this name, or the main antenna if there is none.
    [[nodiscard]] pointing::Antenna antenna(const std::string& name) const;
    // The pointing terms of the beam of this antenna.
    [[nodiscard]] pointing::PointingTerms termsOf(const pointing::Antenna& antenna) const
    {
        return pointing::termsFor(pointing, antenna, missing());
    }
    // How far beside a moving target an axis may stand whose motor is only switched on and off.
    [[nodiscard]] Angle deadBand(const pointing::Antenna& antenna) const;
    // The main antenna and all others, in the order of the file.
    [[nodiscard]] std::vector<pointing::Antenna> allAntennas() const;
    bool operator==(const Profile&) const = default;
};

}  // namespace boresight::profile

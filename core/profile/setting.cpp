// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/gs232/esp32_offsets.h"
#include "core/listeners/listener.h"
#include "core/profile/commissioning.h"
#include "core/profile/further_boards.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"
#include "core/rotctl/hamlib_setting.h"

#include <algorithm>
#include <utility>

namespace boresight::profile {

using namespace makers;

namespace {

void addMount(std::vector<Setting>& list)
{
    list.push_back(name(
        "mount.name", Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Name of the mount"),
         QT_TRANSLATE_NOOP(
             "Text",
             "The name of this mount for clients and in the window. Its position journal is kept under this name.")},
        [](auto& p) -> auto& { return p.mount.name; }));
    list.push_back(number(
        "mount.beam_width_deg", "°", {0.01, 180.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Beam width"),
         QT_TRANSLATE_NOOP("Text", "Half-power beam width of the antenna. The sky shows it as a circle.")},
        [](auto& p) -> auto& { return p.mount.beamWidth; }));
    list.push_back(choice(
        "mount.directions",
        {{"confirmed", QT_TRANSLATE_NOOP("Text", "Confirmed")},
         {"unconfirmed", QT_TRANSLATE_NOOP("Text", "Not confirmed")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Directions confirmed"),
         QT_TRANSLATE_NOOP("Text",
                           "Whether somebody has checked that each axis turns in the direction of this file. Until "
                           "then every motion is short and slow. Without this key a real mount is unconfirmed.")},
        [](auto& p) -> auto& { return p.mount.directions; }));
    list.back().assume = [](Profile& p) {
        p.mount.directions = namesNoBus(p) ? Directions::Confirmed : Directions::Unconfirmed;
    };
    addMountGeometry(list);
    list.push_back(textual(
        "bus.name", Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Bus"),
         QT_TRANSLATE_NOOP("Text",
                           "How Boresight reaches the drives: \"fdcanusb:PATH\" or \"socketcan:INTERFACE\" for moteus, "
                           "\"serial:PATH\" or \"tcp:HOST:PORT\" for a GS-232 rotator, \"rotctld:HOST:PORT\" or "
                           "\"hamlib:MODEL:PORT\" for a rotator of Hamlib, or \"simulated\".")},
        [](const Profile& p) { return p.bus; },
        [](Profile& p, const std::string& text) {
            return parseBusName(text).map([&](const BusName&) { p.bus = text; });
        }));
    list.push_back(integer(
        "bus.baud", "Bd", {300, 115200}, Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Speed of the serial port"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Speed of the serial port of a GS-232 rotator or of a model of Hamlib, as its switches are set. "
             "A CAN bus does not use it.")},
        [](auto& p) -> auto& { return p.baud; }));
    list.push_back(textList(
        "bus.hamlib_settings", Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Settings of Hamlib"),
         QT_TRANSLATE_NOOP("Text",
                           "Further settings for the rotctld that Boresight starts for a model of Hamlib, such as "
                           "\"stop_bits=2\" or \"min_az=-90\". \"rotctl -m MODEL -L\" lists their names.")},
        [](auto& p) -> auto& { return p.hamlibSettings; },
        [](const std::string& text) {
            return rotctl::parseHamlibSetting(text).map([](const rotctl::HamlibSetting&) {});
        }));
    list.push_back(textList(
        "bus.watched", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Watched boards"),
         QT_TRANSLATE_NOOP("Text",
                           "Further moteus boards on the bus, each with its id and a name: \"3 polarisation\". "
                           "Boresight shows what they report. It never commands them.")},
        [](auto& p) -> auto& { return p.watchedBoards; },
        [](const std::string& text) { return parseWatchedBoard(text).map([](const WatchedBoard&) {}); }));
}

std::vector<SettingChoice> drivers()
{
    std::vector<SettingChoice> choices;
    for (const DriverKind& kind : kDriverKinds) {
        choices.push_back({std::string(kind.name), std::string(kind.title)});
    }
    return choices;
}

void addGeometry(std::vector<Setting>& list, const std::string& table, AxisSettings Profile::*axis)
{
    constexpr auto kOnReconnect = Applies::OnReconnect;
    constexpr Range kTravel{-3600.0, 3600.0};
    list.push_back(choice(
        table + ".driver", drivers(), kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Driver"), kDriverMeaning}, [axis](auto& p) -> auto& { return (p.*axis).driver; }));
    list.push_back(integer(
        table + ".id", "", {1, 126}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "CAN id"),
         QT_TRANSLATE_NOOP("Text", "CAN id of the moteus controller of this axis.")},
        [axis](auto& p) -> auto& { return (p.*axis).id; }));
    list.push_back(integer(
        table + ".sign", "", {-1, 1}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Motor direction"),
         QT_TRANSLATE_NOOP("Text", "1, or -1 if the motor counts down while the axis angle grows. 0 is refused.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.sign; }));
    list.push_back(number(
        table + ".offset_deg", "°", {-3600.0, 3600.0}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Axis zero offset"),
         QT_TRANSLATE_NOOP("Text", "motor turns = sign × (angle + offset) / 360 × gear ratio.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.offset; }));
    list.push_back(number(
        table + ".gear_ratio", "", {0.001, 10000.0}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Gear ratio"),
         QT_TRANSLATE_NOOP("Text", "Turns of the motor for one turn of the axis.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.gearRatio; }));
    list.push_back(choice(
        table + ".gear_in",
        {{"drive", QT_TRANSLATE_NOOP("Text", "Drive")}, {"host", QT_TRANSLATE_NOOP("Text", "This computer")}},
        kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Gear ratio applied in"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Where the gear ratio is applied. With \"drive\" the controller already counts turns of the axis.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.gearIn; }));
    list.push_back(number(
        table + ".travel_min_deg", "°", kTravel, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Travel from"),
         QT_TRANSLATE_NOOP("Text", "Lower end of the permitted travel, as an axis angle.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.travel.min; }));
    list.push_back(number(
        table + ".travel_max_deg", "°", kTravel, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Travel to"),
         QT_TRANSLATE_NOOP("Text", "Upper end of the permitted travel, as an axis angle: 370° is not 10°.")},
        [axis](auto& p) -> auto& { return (p.*axis).geometry.travel.max; }));
    list.push_back(number(
        table + ".steps_per_turn", "", {0.0, 1e6}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Steps per turn"),
         QT_TRANSLATE_NOOP(
             "Text",
             "The number of positions of a rotator in a full turn, from the position 0: 866, or 1024 for 512 steps in "
             "180°. Boresight sends it only to these. A box that counts coarser keeps its own steps. A moteus has no "
             "steps. 0: as the box counts.")},
        [axis](auto& p) -> auto& { return (p.*axis).stepsPerTurn; }));
}

void addLimits(std::vector<Setting>& list, const std::string& table, AxisSettings Profile::*axis)
{
    list.push_back(number(
        table + ".max_speed_deg_s", "°/s", {0.01, 360.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Top speed"), QT_TRANSLATE_NOOP("Text", "The highest speed of the axis.")},
        [axis](auto& p) -> auto& { return (p.*axis).limits.speed; }));
    list.push_back(number(
        table + ".max_acceleration_deg_s2", "°/s²", {0.01, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Acceleration"),
         QT_TRANSLATE_NOOP("Text", "Largest change of speed, also in a stop.")},
        [axis](auto& p) -> auto& { return (p.*axis).limits.acceleration; }));
    list.push_back(number(
        table + ".max_jerk_deg_s3", "°/s³", {0.01, 360000.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Jerk"),
         QT_TRANSLATE_NOOP("Text",
                           "Largest jerk: how fast the acceleration may change. It makes every stop longer by "
                           "2 × acceleration / jerk seconds.")},
        [axis](auto& p) -> auto& { return (p.*axis).limits.jerk; }));
    list.push_back(number(
        table + ".max_torque_nm", "Nm", {0.01, 10000.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Largest torque"),
         QT_TRANSLATE_NOOP("Text", "The largest torque that the drive uses, as its controller measures it.")},
        [axis](auto& p) -> auto& { return (p.*axis).maxTorque; }));
    list.push_back(choice(
        table + ".power_up_position", powerUpChoices(), Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Position after power-up"),
         QT_TRANSLATE_NOOP(
             "Text",
             "\"trusted\" if the position after power-up is always right: an encoder on the axis and a travel below "
             "one turn. Otherwise the axis points only while the drive reports a referenced output.")},
        [axis](auto& p) -> auto& { return (p.*axis).powerUpPosition; }));
    list.push_back(choice(
        table + ".timeout_mode",
        {{"hold", QT_TRANSLATE_NOOP("Text", "Hold position")}, {"brake", QT_TRANSLATE_NOOP("Text", "Brake")}},
        Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "If commands stop"),
         QT_TRANSLATE_NOOP("Text",
                           "What the drive does by itself when its watchdog expires: \"hold\" (servo.timeout_mode 10) "
                           "or \"brake\" (15, for self-locking gearboxes only).")},
        [axis](auto& p) -> auto& { return (p.*axis).timeoutMode; }));
}

void addRotator(std::vector<Setting>& list)
{
    list.push_back(choice(
        "rotator.rare_starts", offOn(), Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Rare motor starts"),
         QT_TRANSLATE_NOOP("Text",
                           "\"on\" starts the motors of a rotator seldom. Choose it if the control box only switches "
                           "them on and off. \"off\" sends each step of the target.")},
        [](auto& p) -> auto& { return p.rotator.rareStarts; }));
    list.push_back(number(
        "rotator.dead_band_deg", "°", {0.0, 10.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Dead-band"),
         QT_TRANSLATE_NOOP("Text",
                           "With rare motor starts, a motor starts when a tracked target is this far away. Beside a "
                           "keep-out, the horizon and the Sun there is no dead-band. 0: 0.15 of the beam width, at "
                           "most 5°.")},
        [](auto& p) -> auto& { return p.rotator.deadBand; }));
    list.push_back(integer(
        "rotator.max_starts_per_min", "", {0, 120}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Most motor starts per minute"),
         QT_TRANSLATE_NOOP("Text",
                           "With rare motor starts, a motor starts at most this often in a minute while a target is "
                           "tracked. The limit does not apply to a slew, to a jog, and beside a keep-out, the "
                           "horizon or the Sun. 0: no limit.")},
        [](auto& p) -> auto& { return p.rotator.mostStarts; }));
    list.push_back(number(
        "rotator.coast_deg", "°", {0.0, 2.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Coast"),
         QT_TRANSLATE_NOOP("Text",
                           "With rare motor starts, how far an axis goes on when its motor is switched off. An axis "
                           "that is nearer to its target stays there. 0: as Boresight measures it.")},
        [](auto& p) -> auto& { return p.rotator.coast; }));
    list.push_back(textual(
        "rotator.sensor_offsets", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Saved sensor offsets"),
         QT_TRANSLATE_NOOP("Text",
                           "The offsets that the sensor of an ESP32 relay controller reported when they were saved "
                           "(Mount > Console, Save offsets). Boresight compares them at each connection. It cannot "
                           "write them to the box. Empty: not compared.")},
        [](const Profile& p) { return p.rotator.sensorOffsets; },
        [](Profile& p, const std::string& wanted) -> Result<> {
            if (!wanted.empty() && !gs232::esp32::parseOffsets(wanted)) {
                return failure(
                    ErrorCode::InvalidInput,
                    Text::tr("offsets are expected like \"%1\"").arg(toQString(gs232::esp32::offsetsText({}))));
            }
            p.rotator.sensorOffsets = wanted;
            return {};
        }));
}

void addControl(std::vector<Setting>& list)
{
    list.push_back(integer(
        "control.tick_hz", "Hz", {20, 200}, Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Set-points per second"),
         QT_TRANSLATE_NOOP("Text", "How often each drive gets a new set-point.")},
        [](auto& p) -> auto& { return p.control.tickHz; }));
    list.push_back(number(
        "control.watchdog_s", "s", {0.05, 0.2}, Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Drive watchdog"),
         QT_TRANSLATE_NOOP("Text", "The drives stop by themselves after this time without a command.")},
        [](auto& p) -> auto& { return p.control.watchdog; }));
    list.push_back(choice(
        "control.arrival",
        {{"separate", QT_TRANSLATE_NOOP("Text", "Separately")}, {"together", QT_TRANSLATE_NOOP("Text", "Together")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Arrival of the axes"),
         QT_TRANSLATE_NOOP(
             "Text",
             "How the axes arrive at the end of a slew. \"separate\": each axis arrives as soon as it can. "
             "\"together\": the faster axis slows down so that both arrive at the same time.")},
        [](auto& p) -> auto& { return p.control.arrival; }));
    list.push_back(choice(
        "control.after_stall",
        {{"resume", QT_TRANSLATE_NOOP("Text", "Resume")}, {"wait", QT_TRANSLATE_NOOP("Text", "Wait for re-arm")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "After a stall"),
         QT_TRANSLATE_NOOP("Text",
                           "What Boresight does after this computer stalled for up to 2 s and the watchdogs stopped "
                           "the drives: resume the motion, or wait for a re-arm.")},
        [](auto& p) -> auto& { return p.control.afterStall; }));
    list.push_back(choice(
        "control.on_exit",
        {{"hold", QT_TRANSLATE_NOOP("Text", "Hold position")},
         {"brake", QT_TRANSLATE_NOOP("Text", "Brake")},
         {"off", QT_TRANSLATE_NOOP("Text", "Torque off")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "At program end"),
         QT_TRANSLATE_NOOP("Text",
                           "The state of the drives after the program ends. \"hold\" needs servo.timeout_mode 10 in "
                           "the drives. Without this mode they only damp.")},
        [](auto& p) -> auto& { return p.control.onExit; }));
    list.push_back(number(
        "control.drive_limit_margin_deg", "°", {0.5, 20.0}, Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Margin of the drives' own limits"),
         QT_TRANSLATE_NOOP(
             "Text",
             "The position limits in the drives lie this far beyond the travel. They hold without this program.")},
        [](auto& p) -> auto& { return p.control.driveLimitMargin; }));
    list.push_back(number(
        "park.azimuth_deg", "°", {-3600.0, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Park azimuth"),
         QT_TRANSLATE_NOOP("Text", "Azimuth of the park position, as an axis angle.")},
        [](auto& p) -> auto& { return p.park.azimuth; }));
    list.push_back(number(
        "park.elevation_deg", "°", {-3600.0, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Park elevation"),
         QT_TRANSLATE_NOOP("Text", "Elevation of the park position, as an axis angle.")},
        [](auto& p) -> auto& { return p.park.elevation; }));
    list.push_back(number(
        "park.after_min", "min", {0.0, 1440.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Park when idle"),
         QT_TRANSLATE_NOOP("Text",
                           "The mount parks after this time without a motion and without a command of the operator or "
                           "of a client. A client that only reads the position does not count. 0: never.")},
        [](auto& p) -> auto& { return p.parkAfter; }));
}

void addJog(std::vector<Setting>& list)
{
    constexpr Range kJogRate{0.001, 360.0};
    list.push_back(number(
        "jog.slow_deg_s", "°/s", kJogRate, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Slow jog rate"), QT_TRANSLATE_NOOP("Text", "The lowest jog rate of the slider.")},
        [](auto& p) -> auto& { return p.jog.slow; }));
    list.push_back(number(
        "jog.normal_deg_s", "°/s", kJogRate, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Normal jog rate"), QT_TRANSLATE_NOOP("Text", "The jog rate at the start.")},
        [](auto& p) -> auto& { return p.jog.normal; }));
    list.push_back(number(
        "jog.fast_deg_s", "°/s", kJogRate, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Fast jog rate"),
         QT_TRANSLATE_NOOP("Text", "The highest jog rate of the slider, and the rate of Shift + arrow.")},
        [](auto& p) -> auto& { return p.jog.fast; }));
    list.push_back(number(
        "jog.unwind_deg_s", "°/s", {0.01, 5.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Jog rate while the wrap is unknown"),
         QT_TRANSLATE_NOOP("Text", "The highest jog rate while the cable wrap of an axis is unknown.")},
        [](auto& p) -> auto& { return p.jog.unwind; }));
}

void addClients(std::vector<Setting>& list)
{
    list.push_back(textual(
        "rotctld.listen", Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Listen on"),
         QT_TRANSLATE_NOOP(
             "Text",
             "HOST:PORT for rotctld clients. Port 0 takes any free port. 127.0.0.1 admits this computer only.")},
        [](const Profile& p) { return toText(p.rotctld.listen); },
        [](Profile& p, const std::string& text) {
            return parseListenAddress(text).map([&](const ListenAddress& listen) { p.rotctld.listen = listen; });
        }));
    list.push_back(textList(
        "rotctld.allow", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Allowed addresses"),
         QT_TRANSLATE_NOOP("Text",
                           "Addresses and networks that may connect, for example \"192.168.1.7\" or \"10.0.0.0/8\". "
                           "Empty: every client that reaches the port.")},
        [](auto& p) -> auto& { return p.rotctld.allow; }, checkNetwork));
    list.push_back(choice(
        "rotctld.lead",
        {{"first", QT_TRANSLATE_NOOP("Text", "First client")},
         {"last", QT_TRANSLATE_NOOP("Text", "Latest client")},
         {"locked", QT_TRANSLATE_NOOP("Text", "One client only")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Control goes to"),
         QT_TRANSLATE_NOOP("Text",
                           "Which client moves the mount. \"first\": the first client, until it has sent no motion "
                           "command for 10 s. \"last\": the client with the latest motion command, as with Hamlib. "
                           "\"locked\": only the client of \"Locked to\".")},
        [](auto& p) -> auto& { return p.rotctld.control; }));
    list.push_back(textual(
        "rotctld.locked_to", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Locked to"),
         QT_TRANSLATE_NOOP("Text", "Address of the only client that may move the mount while control is \"locked\".")},
        [](const Profile& p) { return p.rotctld.lockedTo; },
        [](Profile& p, const std::string& text) {
            return (text.empty() ? Result<>{} : checkAddress(text)).map([&] { p.rotctld.lockedTo = text; });
        }));
    list.push_back(choice(
        "rotctld.outside_limits",
        {{"nearest", QT_TRANSLATE_NOOP("Text", "Nearest point")}, {"refuse", QT_TRANSLATE_NOOP("Text", "Refuse")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Target outside the limits"),
         QT_TRANSLATE_NOOP("Text", "Go to the nearest permitted point, or refuse the command.")},
        [](auto& p) -> auto& { return p.rotctld.outsideLimits; }));
    list.push_back(choice(
        "rotctld.azimuth",
        {{"0..360", QT_TRANSLATE_NOOP("Text", "0…360°")},
         {"-180..180", QT_TRANSLATE_NOOP("Text", "-180…180°")},
         {"continuous", QT_TRANSLATE_NOOP("Text", "Continuous")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Azimuth for clients"),
         QT_TRANSLATE_NOOP(
             "Text",
             "The form of the reported azimuth. \"continuous\" counts the turns of the axis: 370° is not 10°.")},
        [](auto& p) -> auto& { return p.rotctld.azimuth; }));
    list.push_back(choice(
        "rotctld.dump_state",
        {{"old_and_new", QT_TRANSLATE_NOOP("Text", "Old and new Hamlib")},
         {"as_hamlib", QT_TRANSLATE_NOOP("Text", "As Hamlib 4.5.1")}},
        Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Form of the state dump"),
         QT_TRANSLATE_NOOP("Text",
                           "Form of the \\dump_state reply. Every version of Hamlib reads \"old_and_new\". "
                           "\"as_hamlib\" is exactly the reply of Hamlib 4.5.1 and later.")},
        [](auto& p) -> auto& { return p.rotctld.dumpState; }));
    list.push_back(integer(
        "rotctld.max_clients", "", {1, 5000}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Most clients"),
         QT_TRANSLATE_NOOP("Text", "The largest number of connections at the same time.")},
        [](auto& p) -> auto& { return p.rotctld.maxClients; }));
    list.push_back(textList(
        "listeners.list", Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Further listeners"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Listeners for programs that do not speak rotctld. Each has a protocol (\"gs232a\", \"gs232b\", "
             "\"easycomm1\", \"easycomm2\", \"easycomm3\", \"pairs\", \"pst\" or \"n1mm\"), the right to \"drive\" "
             "or only to \"read\", and a place: \"gs232b drive tcp:127.0.0.1:4534\", \"gs232a read pty:/tmp/rotator\", "
             "\"pairs drive unix:/tmp/pairs\" or \"pst drive udp:127.0.0.1:12000\". Addresses and networks that may "
             "connect by TCP or UDP can follow, and for N1MM \"rotor=NAME\". Empty: none.")},
        [](auto& p) -> auto& { return p.listeners; },
        [](const std::string& text) { return listeners::parseListener(text).map([](const auto&) {}); }));
}

std::vector<Setting> makeSettings()
{
    std::vector<Setting> list;
    addMount(list);
    for (const auto& [table, axis] :
         {std::pair{"azimuth", &Profile::azimuth}, std::pair{"elevation", &Profile::elevation}}) {
        addGeometry(list, table, axis);
        addLimits(list, table, axis);
    }
    addThirdAxis(list);
    addPointing(list);
    addRegion(list);
    addRotator(list);
    addControl(list);
    addSite(list);
    addGpredict(list);
    addOrbit(list);
    addAzel(list);
    addPosition(list);
    addSchedule(list);
    addRecord(list);
    addSun(list);
    addJog(list);
    addClients(list);
    addClientLock(list);
    addSupervision(list);
    addRecovery(list);
    addSensor(list);
    addBroker(list);
    addPower(list);
    addTransmit(list);
    addBrake(list);
    addEndSwitches(list);
    addWind(list);
    return list;
}

}  // namespace

std::span<const Setting> settings()
{
    static const std::vector<Setting> list = makeSettings();
    return list;
}

const Setting* findSetting(std::string_view key)
{
    const auto all = settings();
    const auto found = std::find_if(all.begin(), all.end(), [key](const Setting& s) { return s.key == key; });
    return found != all.end() ? &*found : nullptr;
}

bool hasSecrets(const Profile& profile)
{
    return withoutSecrets(profile) != profile;
}

Profile withoutSecrets(Profile profile)
{
    for (const Setting& setting : settings()) {
        if (setting.secret && setting.get(profile) != SettingValue(std::string())) {
            (void)setting.set(profile, std::string(kHidden));
        }
    }
    return profile;
}

QString toText(const Problem& problem)
{
    return QStringLiteral("%1: %2").arg(toQString(problem.key), problem.text);
}

}  // namespace boresight::profile

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting.h"

#include "core/base/bus_name.h"
#include "core/base/control_characters.h"
#include "core/profile/setting_makers.h"

#include <algorithm>
#include <utility>

namespace boresight::profile {

using namespace makers;

namespace {

void addMount(std::vector<Setting>& list)
{
    list.push_back(textual(
        "mount.name", Applies::Now, "What clients and the window call this mount.",
        [](const Profile& p) { return p.mount.name; },
        [](Profile& p, const std::string& text) -> Result<> {
            if (text.empty() || text.size() > 60 || hasControlCharacters(text)) {
                return failure(ErrorCode::InvalidInput, "one line of 1 to 60 bytes is expected");
            }
            p.mount.name = text;
            return {};
        }));
    list.push_back(number(
        "mount.beam_width_deg", "°", {0.01, 180.0}, Applies::Now,
        "Half-power beam width of the antenna, drawn in the polar plot.",
        [](auto& p) -> auto& { return p.mount.beamWidth; }));
    list.push_back(textual(
        "bus.name", Applies::OnReconnect,
        "How the drives are reached: \"fdcanusb:PATH\", \"socketcan:INTERFACE\" or \"simulated\".",
        [](const Profile& p) { return p.bus; },
        [](Profile& p, const std::string& text) {
            return parseBusName(text).map([&](const BusName&) { p.bus = text; });
        }));
}

void addGeometry(std::vector<Setting>& list, const std::string& table, AxisSettings Profile::*axis)
{
    constexpr auto kOnReconnect = Applies::OnReconnect;
    constexpr Range kTravel{-3600.0, 3600.0};
    list.push_back(integer(
        table + ".id", "", {1, 126}, kOnReconnect,
        "CAN id of the axis's moteus controller.", [axis](auto& p) -> auto& { return (p.*axis).id; }));
    list.push_back(integer(
        table + ".sign", "", {-1, 1}, kOnReconnect,
        "1, or -1 when the motor counts down while the axis angle grows; 0 is refused.", [axis](auto& p) -> auto& {
            return (p.*axis).geometry.sign;
        }));
    list.push_back(number(
        table + ".offset_deg", "°", {-3600.0, 3600.0}, kOnReconnect,
        "motor turns = sign × (angle + offset) / 360 × gear ratio.", [axis](auto& p) -> auto& {
            return (p.*axis).geometry.offset;
        }));
    list.push_back(number(
        table + ".gear_ratio", "", {0.001, 10000.0}, kOnReconnect,
        "Turns of the motor per turn of the axis.", [axis](auto& p) -> auto& { return (p.*axis).geometry.gearRatio; }));
    list.push_back(choice(
        table + ".gear_in", {"drive", "host"}, kOnReconnect,
        "Who applies the gear ratio: with \"drive\" the controller already counts turns of the axis.",
        [axis](auto& p) -> auto& { return (p.*axis).geometry.gearIn; }));
    list.push_back(number(
        table + ".travel_min_deg", "°", kTravel, kOnReconnect,
        "Lower end of the permitted travel, as a mechanical angle.", [axis](auto& p) -> auto& {
            return (p.*axis).geometry.travel.min;
        }));
    list.push_back(number(
        table + ".travel_max_deg", "°", kTravel, kOnReconnect,
        "Upper end of the permitted travel; 370° is not 10°.", [axis](auto& p) -> auto& {
            return (p.*axis).geometry.travel.max;
        }));
}

void addLimits(std::vector<Setting>& list, const std::string& table, AxisSettings Profile::*axis)
{
    list.push_back(number(
        table + ".max_speed_deg_s", "°/s", {0.01, 360.0}, Applies::Now,
        "Fastest motion of the axis.", [axis](auto& p) -> auto& { return (p.*axis).limits.speed; }));
    list.push_back(number(
        table + ".max_acceleration_deg_s2", "°/s²", {0.01, 3600.0}, Applies::Now,
        "Fastest change of speed, also when stopping.", [axis](auto& p) -> auto& {
            return (p.*axis).limits.acceleration;
        }));
    list.push_back(number(
        table + ".max_jerk_deg_s3", "°/s³", {0.01, 360000.0}, Applies::Now,
        "Fastest change of acceleration; 2 × acceleration / jerk seconds are lost in every stop.",
        [axis](auto& p) -> auto& { return (p.*axis).limits.jerk; }));
    list.push_back(number(
        table + ".max_torque_nm", "Nm", {0.01, 10000.0}, Applies::Now,
        "Torque the drive may use, as the controller counts it.", [axis](auto& p) -> auto& {
            return (p.*axis).maxTorque;
        }));
    list.push_back(choice(
        table + ".power_up_position", {"ambiguous", "trusted"}, Applies::OnReconnect,
        "\"trusted\" if the position after power-up is always right (encoder on the axis, travel below one turn); else "
        "the axis is only pointed when the drive reports a referenced output.",
        [axis](auto& p) -> auto& { return (p.*axis).powerUpPosition; }));
    list.push_back(choice(
        table + ".timeout_mode", {"hold", "brake"}, Applies::OnReconnect,
        "What the drive does by itself when its watchdog expires: \"hold\" (servo.timeout_mode 10) or \"brake\" (15, "
        "for "
        "self-locking gearboxes only).",
        [axis](auto& p) -> auto& { return (p.*axis).timeoutMode; }));
}

void addControl(std::vector<Setting>& list)
{
    list.push_back(integer(
        "control.tick_hz", "Hz", {20, 200}, Applies::OnReconnect, "Set-points per second.",
        [](auto& p) -> auto& { return p.control.tickHz; }));
    list.push_back(number(
        "control.watchdog_s", "s", {0.05, 0.2}, Applies::OnReconnect,
        "The drives stop by themselves after this time without a command.",
        [](auto& p) -> auto& { return p.control.watchdog; }));
    list.push_back(choice(
        "control.on_exit", {"hold", "brake", "off"}, Applies::Now,
        "What the drives are left doing when the program ends. hold needs servo.timeout_mode 10 in the drives, else "
        "they only "
        "damp.",
        [](auto& p) -> auto& { return p.control.onExit; }));
    list.push_back(number(
        "control.drive_limit_margin_deg", "°", {0.5, 20.0}, Applies::OnReconnect,
        "How far beyond the travel the drives' own position bounds lie, a second limit that holds without this "
        "program.",
        [](auto& p) -> auto& { return p.control.driveLimitMargin; }));
    list.push_back(number(
        "park.azimuth_deg", "°", {-3600.0, 3600.0}, Applies::Now, "Park position, as a mechanical angle.",
        [](auto& p) -> auto& { return p.park.azimuth; }));
    list.push_back(number(
        "park.elevation_deg", "°", {-3600.0, 3600.0}, Applies::Now, "Park position, as a mechanical angle.",
        [](auto& p) -> auto& { return p.park.elevation; }));
}

void addOperation(std::vector<Setting>& list)
{
    constexpr Range kJogRate{0.001, 360.0};
    list.push_back(number(
        "jog.slow_deg_s", "°/s", kJogRate, Applies::Now, "Slow jog rate.",
        [](auto& p) -> auto& { return p.jog.slow; }));
    list.push_back(number(
        "jog.normal_deg_s", "°/s", kJogRate, Applies::Now, "Normal jog rate.",
        [](auto& p) -> auto& { return p.jog.normal; }));
    list.push_back(number(
        "jog.fast_deg_s", "°/s", kJogRate, Applies::Now, "Fast jog rate.",
        [](auto& p) -> auto& { return p.jog.fast; }));
    list.push_back(number(
        "jog.unwind_deg_s", "°/s", {0.01, 5.0}, Applies::Now,
        "Fastest jog while it is not known on which turn an axis stands.",
        [](auto& p) -> auto& { return p.jog.unwind; }));
    list.push_back(textual(
        "rotctld.listen", Applies::OnReconnect,
        "HOST:PORT for rotctld clients; port 0 takes any free one. 127.0.0.1 keeps other machines out.",
        [](const Profile& p) { return toText(p.rotctld.listen); },
        [](Profile& p, const std::string& text) {
            return parseListenAddress(text).map([&](const ListenAddress& listen) { p.rotctld.listen = listen; });
        }));
    list.push_back(choice(
        "rotctld.outside_limits", {"nearest", "refuse"}, Applies::Now,
        "A direction outside the travel: drive to the nearest permitted point, or refuse it.",
        [](auto& p) -> auto& { return p.rotctld.outsideLimits; }));
    list.push_back(choice(
        "rotctld.azimuth", {"0..360", "-180..180", "continuous"}, Applies::Now,
        "How clients are told the azimuth; \"continuous\" is the mechanical angle.",
        [](auto& p) -> auto& { return p.rotctld.azimuth; }));
    list.push_back(choice(
        "rotctld.dump_state", {"old_and_new", "as_hamlib"}, Applies::OnReconnect,
        "Form of the \\dump_state reply: readable for Hamlib clients of every age, or exactly as Hamlib 4.5.1 and "
        "later.",
        [](auto& p) -> auto& { return p.rotctld.dumpState; }));
    list.push_back(integer(
        "rotctld.max_clients", "", {1, 5000}, Applies::Now, "Connections served at the same time.",
        [](auto& p) -> auto& { return p.rotctld.maxClients; }));
}

void addMotionSupervision(std::vector<Setting>& list)
{
    constexpr auto kNow = Applies::Now;
    constexpr Range kError{0.1, 90.0};
    list.push_back(number(
        "supervision.following_hint_deg", "°", kError, kNow,
        "A hint when set-point and axis stay so far apart for following_time_s.",
        [](auto& p) -> auto& { return p.supervision.followingHint; }));
    list.push_back(number(
        "supervision.following_stop_deg", "°", kError, kNow,
        "The mount stops when set-point and axis stay so far apart for following_time_s.",
        [](auto& p) -> auto& { return p.supervision.followingStop; }));
    list.push_back(number(
        "supervision.following_time_s", "s", {0.1, 5.0}, kNow, "How long a following error may last.",
        [](auto& p) -> auto& { return p.supervision.followingTime; }));
    list.push_back(number(
        "supervision.stall_time_s", "s", {0.2, 5.0}, kNow,
        "The mount stops when an axis is commanded to move and has not moved for so long.",
        [](auto& p) -> auto& { return p.supervision.stallTime; }));
    list.push_back(number(
        "supervision.uncommanded_deg", "°", kError, kNow,
        "An axis that should stand and has moved by so much stops the mount, or is a hint while its drive is off.",
        [](auto& p) -> auto& { return p.supervision.uncommanded; }));
    list.push_back(number(
        "supervision.encoder_jump_deg", "°", {0.1, 45.0}, kNow,
        "The mount stops when an angle changes between two replies by so much more than the axis can turn.",
        [](auto& p) -> auto& { return p.supervision.encoderJump; }));
    list.push_back(number(
        "supervision.outside_hint_deg", "°", kError, kNow, "A hint when an axis is so far beyond its travel.",
        [](auto& p) -> auto& { return p.supervision.outsideHint; }));
    list.push_back(number(
        "supervision.outside_stop_deg", "°", kError, kNow,
        "The mount stops when an axis is so far beyond its travel and moves farther out.",
        [](auto& p) -> auto& { return p.supervision.outsideStop; }));
    list.push_back(number(
        "supervision.torque_hint_share", "", {0.1, 1.0}, kNow,
        "A hint when an axis needs this share of its max_torque_nm for 2 s.",
        [](auto& p) -> auto& { return p.supervision.torqueHint; }));
    list.push_back(number(
        "supervision.torque_unwind_share", "", {0.05, 1.0}, kNow,
        "While the turn of an axis is unknown, the mount stops at this share of its max_torque_nm: a cable may pull.",
        [](auto& p) -> auto& { return p.supervision.torqueUnwind; }));
}

void addDriveSupervision(std::vector<Setting>& list)
{
    constexpr auto kNow = Applies::Now;
    constexpr Range kVoltage{5.0, 60.0};
    constexpr Range kTemperature{30.0, 150.0};
    list.push_back(number(
        "supervision.reply_age_s", "s", {0.02, 0.25}, kNow, "A hint when the last reply of a drive is older.",
        [](auto& p) -> auto& { return p.supervision.replyAge; }));
    list.push_back(number(
        "supervision.supply_low_v", "V", kVoltage, kNow, "A hint below this supply voltage.",
        [](auto& p) -> auto& { return p.supervision.supplyLow; }));
    list.push_back(number(
        "supervision.supply_stop_v", "V", kVoltage, kNow,
        "The mount stops below this supply voltage, while the drives still can.",
        [](auto& p) -> auto& { return p.supervision.supplyStop; }));
    list.push_back(number(
        "supervision.supply_high_v", "V", kVoltage, kNow,
        "A hint above this supply voltage; a stop would brake and drive it higher.",
        [](auto& p) -> auto& { return p.supervision.supplyHigh; }));
    list.push_back(number(
        "supervision.board_hot_c", "°C", kTemperature, kNow, "A hint when the board of a drive is so hot.",
        [](auto& p) -> auto& { return p.supervision.boardHot; }));
    list.push_back(number(
        "supervision.board_limit_c", "°C", kTemperature, kNow,
        "Where the drive gives up with fault 38 (servo.fault_temperature); trends are reckoned to it.",
        [](auto& p) -> auto& { return p.supervision.boardLimit; }));
    list.push_back(number(
        "supervision.motor_hot_c", "°C", kTemperature, kNow, "A hint when a motor with a sensor is so hot.",
        [](auto& p) -> auto& { return p.supervision.motorHot; }));
    list.push_back(number(
        "supervision.trend_ahead_s", "s", {10.0, 3600.0}, kNow,
        "A hint when supply or temperature, going on as in the last minute, reach their limit within this time.",
        [](auto& p) -> auto& { return p.supervision.trendAhead; }));
}

void addRecovery(std::vector<Setting>& list)
{
    constexpr auto kNow = Applies::Now;
    const std::vector<std::string> retry{"never", "once", "interval"};
    list.push_back(choice(
        "recovery.over_temperature", retry, kNow,
        "Re-arm without a person when a drive that was too hot (fault 38) has cooled down by 5 °C.",
        [](auto& p) -> auto& { return p.recovery.overTemperature; }));
    list.push_back(choice(
        "recovery.supply", retry, kNow,
        "Re-arm without a person when the supply (faults 34, 40) is back between supply_low_v and supply_high_v.",
        [](auto& p) -> auto& { return p.recovery.supply; }));
    list.push_back(choice(
        "recovery.bus", retry, kNow, "Re-arm without a person when silent or timed-out drives answer again.",
        [](auto& p) -> auto& { return p.recovery.bus; }));
    list.push_back(number(
        "recovery.interval_s", "s", {5.0, 3600.0}, kNow,
        "Time from a loss, or the last attempt, to the next attempt to re-arm.",
        [](auto& p) -> auto& { return p.recovery.interval; }));
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
    addControl(list);
    addOperation(list);
    addMotionSupervision(list);
    addDriveSupervision(list);
    addRecovery(list);
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

}  // namespace boresight::profile

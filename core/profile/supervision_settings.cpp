// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

void addMotionSupervision(std::vector<Setting>& list)
{
    constexpr Range kError{0.1, 90.0};
    list.push_back(number(
        "supervision.following_hint_deg", "°", kError, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when set-point and axis stay so far apart for following_time_s."),
        [](auto& p) -> auto& { return p.supervision.followingHint; }));
    list.push_back(number(
        "supervision.following_stop_deg", "°", kError, kNow,
        QT_TRANSLATE_NOOP("Text", "The mount stops when set-point and axis stay so far apart for following_time_s."),
        [](auto& p) -> auto& { return p.supervision.followingStop; }));
    list.push_back(number(
        "supervision.following_time_s", "s", {0.1, 5.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "How long a following error may last."),
        [](auto& p) -> auto& { return p.supervision.followingTime; }));
    list.push_back(number(
        "supervision.stall_time_s", "s", {0.2, 5.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "The mount stops when an axis is commanded to move and has not moved for so long."),
        [](auto& p) -> auto& { return p.supervision.stallTime; }));
    list.push_back(number(
        "supervision.uncommanded_deg", "°", kError, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "An axis that should stand and has moved by so much stops the mount, or is a hint while its drive is off."),
        [](auto& p) -> auto& { return p.supervision.uncommanded; }));
    list.push_back(number(
        "supervision.encoder_jump_deg", "°", {0.1, 45.0}, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "The mount stops when an angle changes between two replies by so much more than the axis can turn."),
        [](auto& p) -> auto& { return p.supervision.encoderJump; }));
    list.push_back(number(
        "supervision.outside_hint_deg", "°", kError, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when an axis is so far beyond its travel."),
        [](auto& p) -> auto& { return p.supervision.outsideHint; }));
    list.push_back(number(
        "supervision.outside_stop_deg", "°", kError, kNow,
        QT_TRANSLATE_NOOP("Text", "The mount stops when an axis is so far beyond its travel and moves farther out."),
        [](auto& p) -> auto& { return p.supervision.outsideStop; }));
    list.push_back(number(
        "supervision.torque_hint_share", "", {0.1, 1.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when an axis needs this share of its max_torque_nm for 2 s."),
        [](auto& p) -> auto& { return p.supervision.torqueHint; }));
    list.push_back(number(
        "supervision.torque_at_rest_share", "", {0.05, 1.0}, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "Warn when an axis that stands needs this share of its max_torque_nm for 2 s. Set it a little "
            "above what weight and friction need."),
        [](auto& p) -> auto& { return p.supervision.torqueAtRest; }));
    list.push_back(number(
        "supervision.torque_unwind_share", "", {0.05, 1.0}, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "While the turn of an axis is unknown, the mount stops at this share of its max_torque_nm: a "
                          "cable may pull."),
        [](auto& p) -> auto& { return p.supervision.torqueUnwind; }));
}

void addDriveSupervision(std::vector<Setting>& list)
{
    constexpr Range kVoltage{5.0, 60.0};
    constexpr Range kTemperature{30.0, 150.0};
    list.push_back(number(
        "supervision.reply_age_s", "s", {0.02, 0.25}, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when the last reply of a drive is older."),
        [](auto& p) -> auto& { return p.supervision.replyAge; }));
    list.push_back(number(
        "supervision.supply_low_v", "V", kVoltage, kNow, QT_TRANSLATE_NOOP("Text", "A hint below this supply voltage."),
        [](auto& p) -> auto& { return p.supervision.supplyLow; }));
    list.push_back(number(
        "supervision.supply_stop_v", "V", kVoltage, kNow,
        QT_TRANSLATE_NOOP("Text", "The mount stops below this supply voltage, while the drives still can."),
        [](auto& p) -> auto& { return p.supervision.supplyStop; }));
    list.push_back(number(
        "supervision.supply_high_v", "V", kVoltage, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint above this supply voltage; a stop would brake and drive it higher."),
        [](auto& p) -> auto& { return p.supervision.supplyHigh; }));
    list.push_back(number(
        "supervision.board_hot_c", "°C", kTemperature, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when the board of a drive is so hot."),
        [](auto& p) -> auto& { return p.supervision.boardHot; }));
    list.push_back(number(
        "supervision.board_limit_c", "°C", kTemperature, kNow,
        QT_TRANSLATE_NOOP(
            "Text", "Where the drive gives up with fault 38 (servo.fault_temperature); trends are reckoned to it."),
        [](auto& p) -> auto& { return p.supervision.boardLimit; }));
    list.push_back(number(
        "supervision.motor_hot_c", "°C", kTemperature, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when a motor with a sensor is so hot."),
        [](auto& p) -> auto& { return p.supervision.motorHot; }));
    list.push_back(number(
        "supervision.trend_ahead_s", "s", {10.0, 3600.0}, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "A hint when supply or temperature, going on as in the last minute, reach their limit within this time."),
        [](auto& p) -> auto& { return p.supervision.trendAhead; }));
}

}  // namespace

void addSupervision(std::vector<Setting>& list)
{
    addMotionSupervision(list);
    addDriveSupervision(list);
}

void addRecovery(std::vector<Setting>& list)
{
    const std::vector<std::string> retry{"never", "once", "interval"};
    list.push_back(choice(
        "recovery.over_temperature", retry, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "Re-arm without a person when a drive that was too hot (fault 38) has cooled down by 5 °C."),
        [](auto& p) -> auto& { return p.recovery.overTemperature; }));
    list.push_back(choice(
        "recovery.supply", retry, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "Re-arm without a person when the supply (faults 34, 40) is back between supply_low_v and supply_high_v."),
        [](auto& p) -> auto& { return p.recovery.supply; }));
    list.push_back(choice(
        "recovery.bus", retry, kNow,
        QT_TRANSLATE_NOOP("Text", "Re-arm without a person when silent or timed-out drives answer again."),
        [](auto& p) -> auto& { return p.recovery.bus; }));
    list.push_back(number(
        "recovery.interval_s", "s", {5.0, 3600.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "Time from a loss, or the last attempt, to the next attempt to re-arm."),
        [](auto& p) -> auto& { return p.recovery.interval; }));
}

}  // namespace boresight::profile

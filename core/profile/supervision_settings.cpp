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
        {QT_TRANSLATE_NOOP("Text", "Following error: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn when set-point and axis differ by this angle for the time below.")},
        [](auto& p) -> auto& { return p.supervision.followingHint; }));
    list.push_back(number(
        "supervision.following_stop_deg", "°", kError, kNow,
        {QT_TRANSLATE_NOOP("Text", "Following error: stop"),
         QT_TRANSLATE_NOOP("Text", "Stop the mount when set-point and axis differ by this angle for the time below.")},
        [](auto& p) -> auto& { return p.supervision.followingStop; }));
    list.push_back(number(
        "supervision.following_time_s", "s", {0.1, 5.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Following error: time"),
         QT_TRANSLATE_NOOP("Text", "How long a following error may last.")},
        [](auto& p) -> auto& { return p.supervision.followingTime; }));
    list.push_back(number(
        "supervision.stall_time_s", "s", {0.2, 5.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Blocked axis: time"),
         QT_TRANSLATE_NOOP(
             "Text", "Stop the mount when an axis has not moved for this time although it is commanded to move.")},
        [](auto& p) -> auto& { return p.supervision.stallTime; }));
    list.push_back(number(
        "supervision.uncommanded_deg", "°", kError, kNow,
        {QT_TRANSLATE_NOOP("Text", "Motion without a command"),
         QT_TRANSLATE_NOOP("Text",
                           "Stop the mount when an axis that should stand still has moved by this angle. Warn only "
                           "while its drive is off.")},
        [](auto& p) -> auto& { return p.supervision.uncommanded; }));
    list.push_back(number(
        "supervision.encoder_jump_deg", "°", {0.1, 45.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Jump of the position"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Stop the mount when an angle changes between two replies by this much more than the axis can turn.")},
        [](auto& p) -> auto& { return p.supervision.encoderJump; }));
    list.push_back(number(
        "supervision.outside_hint_deg", "°", kError, kNow,
        {QT_TRANSLATE_NOOP("Text", "Beyond the travel: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn when an axis is this far beyond its travel.")},
        [](auto& p) -> auto& { return p.supervision.outsideHint; }));
    list.push_back(number(
        "supervision.outside_stop_deg", "°", kError, kNow,
        {QT_TRANSLATE_NOOP("Text", "Beyond the travel: stop"),
         QT_TRANSLATE_NOOP("Text", "Stop the mount when an axis is this far beyond its travel and moves farther out.")},
        [](auto& p) -> auto& { return p.supervision.outsideStop; }));
    list.push_back(number(
        "supervision.torque_hint_share", "", {0.1, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "High torque: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn when an axis needs this share of its largest torque for 2 s.")},
        [](auto& p) -> auto& { return p.supervision.torqueHint; }));
    list.push_back(number(
        "supervision.torque_at_rest_share", "", {0.05, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Torque while standing: warn"),
         QT_TRANSLATE_NOOP("Text",
                           "Warn when an axis that stands still needs this share of its largest torque for 2 s. Set it "
                           "a little above the share that weight and friction need.")},
        [](auto& p) -> auto& { return p.supervision.torqueAtRest; }));
    list.push_back(number(
        "supervision.torque_unwind_share", "", {0.05, 1.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Torque while the wrap is unknown"),
         QT_TRANSLATE_NOOP("Text",
                           "While the cable wrap of an axis is unknown, or may have been entered wrongly, stop the "
                           "mount at this share of the largest torque. A cable may pull.")},
        [](auto& p) -> auto& { return p.supervision.torqueUnwind; }));
}

void addDriveSupervision(std::vector<Setting>& list)
{
    constexpr Range kVoltage{5.0, 60.0};
    constexpr Range kTemperature{30.0, 150.0};
    list.push_back(number(
        "supervision.reply_age_s", "s", {0.02, 0.25}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Late reply: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn when the last reply of a drive is older than this.")},
        [](auto& p) -> auto& { return p.supervision.replyAge; }));
    list.push_back(number(
        "supervision.supply_low_v", "V", kVoltage, kNow,
        {QT_TRANSLATE_NOOP("Text", "Low supply: warn"), QT_TRANSLATE_NOOP("Text", "Warn below this supply voltage.")},
        [](auto& p) -> auto& { return p.supervision.supplyLow; }));
    list.push_back(number(
        "supervision.supply_stop_v", "V", kVoltage, kNow,
        {QT_TRANSLATE_NOOP("Text", "Low supply: stop"),
         QT_TRANSLATE_NOOP("Text", "Stop the mount below this supply voltage, while the drives still can.")},
        [](auto& p) -> auto& { return p.supervision.supplyStop; }));
    list.push_back(number(
        "supervision.supply_high_v", "V", kVoltage, kNow,
        {QT_TRANSLATE_NOOP("Text", "High supply: warn"),
         QT_TRANSLATE_NOOP("Text",
                           "Warn above this supply voltage. A stop would brake and raise the voltage further.")},
        [](auto& p) -> auto& { return p.supervision.supplyHigh; }));
    list.push_back(number(
        "supervision.board_hot_c", "°C", kTemperature, kNow,
        {QT_TRANSLATE_NOOP("Text", "Drive board: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn above this drive-board temperature.")},
        [](auto& p) -> auto& { return p.supervision.boardHot; }));
    list.push_back(number(
        "supervision.board_limit_c", "°C", kTemperature, kNow,
        {QT_TRANSLATE_NOOP("Text", "Drive board: limit"),
         QT_TRANSLATE_NOOP("Text",
                           "Temperature at which the drive reports fault 38 (servo.fault_temperature). Trends are "
                           "computed up to it.")},
        [](auto& p) -> auto& { return p.supervision.boardLimit; }));
    list.push_back(number(
        "supervision.motor_hot_c", "°C", kTemperature, kNow,
        {QT_TRANSLATE_NOOP("Text", "Motor: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn above this temperature of a motor with a sensor.")},
        [](auto& p) -> auto& { return p.supervision.motorHot; }));
    list.push_back(number(
        "supervision.trend_ahead_s", "s", {10.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Trend: look ahead"),
         QT_TRANSLATE_NOOP("Text",
                           "Warn when supply or temperature will reach the limit within this time if they change as in "
                           "the last minute.")},
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
    const std::vector<SettingChoice> retry{{"never", QT_TRANSLATE_NOOP("Text", "Never")},
                                           {"once", QT_TRANSLATE_NOOP("Text", "Once")},
                                           {"interval", QT_TRANSLATE_NOOP("Text", "At intervals")}};
    list.push_back(choice(
        "recovery.over_temperature", retry, kNow,
        {QT_TRANSLATE_NOOP("Text", "Re-arm after overheating"),
         QT_TRANSLATE_NOOP("Text",
                           "Re-arm without a person when an overheated drive (fault 38) has cooled down by 5 °C.")},
        [](auto& p) -> auto& { return p.recovery.overTemperature; }));
    list.push_back(choice(
        "recovery.supply", retry, kNow,
        {QT_TRANSLATE_NOOP("Text", "Re-arm after a supply fault"),
         QT_TRANSLATE_NOOP("Text",
                           "Re-arm without a person when the supply voltage (faults 34, 40) is back in its range.")},
        [](auto& p) -> auto& { return p.recovery.supply; }));
    list.push_back(choice(
        "recovery.bus", retry, kNow,
        {QT_TRANSLATE_NOOP("Text", "Re-arm after silence"),
         QT_TRANSLATE_NOOP("Text", "Re-arm without a person when silent or timed-out drives reply again.")},
        [](auto& p) -> auto& { return p.recovery.bus; }));
    list.push_back(number(
        "recovery.interval_s", "s", {5.0, 3600.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Time between attempts"),
         QT_TRANSLATE_NOOP("Text", "Time from a fault, or from the last attempt, to the next attempt to re-arm.")},
        [](auto& p) -> auto& { return p.recovery.interval; }));
}

}  // namespace boresight::profile

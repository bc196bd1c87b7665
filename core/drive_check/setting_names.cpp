// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/setting_names.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::drive_check {

namespace {

constexpr std::string_view kLower = "servopos.position_min";
constexpr std::string_view kUpper = "servopos.position_max";

struct Name
{
    std::string_view key;
    const char* text;
};

constexpr Name kNames[] = {
    {"id.id", QT_TRANSLATE_NOOP("Text", "Bus address")},
    {kLower, QT_TRANSLATE_NOOP("Text", "Lower limit")},
    {kUpper, QT_TRANSLATE_NOOP("Text", "Upper limit")},
    {"servo.default_timeout_s", QT_TRANSLATE_NOOP("Text", "Watchdog time")},
    {"servo.timeout_mode", QT_TRANSLATE_NOOP("Text", "If commands stop")},
    {"servo.timeout_max_torque_Nm", QT_TRANSLATE_NOOP("Text", "Torque after watchdog")},
    {"servo.flux_brake_margin_voltage", QT_TRANSLATE_NOOP("Text", "Braking margin")},
    {"motor_position.output.sign", QT_TRANSLATE_NOOP("Text", "Direction")},
    {"motor_position.output.reference_source", QT_TRANSLATE_NOOP("Text", "Axis encoder")},
    {"servo.max_current_A", QT_TRANSLATE_NOOP("Text", "Max. current")},
    {"servo.max_power_W", QT_TRANSLATE_NOOP("Text", "Max. power")},
    {"servo.max_voltage", QT_TRANSLATE_NOOP("Text", "Max. supply")},
    {"servo.max_velocity", QT_TRANSLATE_NOOP("Text", "Max. speed")},
    {"servo.default_velocity_limit", QT_TRANSLATE_NOOP("Text", "Speed limit")},
    {"servo.default_accel_limit", QT_TRANSLATE_NOOP("Text", "Accel. limit")},
    {"servo.fault_position_error", QT_TRANSLATE_NOOP("Text", "Max. error")},
    {"servo.max_position_slip", QT_TRANSLATE_NOOP("Text", "Max. slip")},
    {"motor_position.rotor_to_output_ratio", QT_TRANSLATE_NOOP("Text", "Gear ratio")},
};

}  // namespace

QString settingName(std::string_view key, bool reversed)
{
    const std::string_view ofAxis = !reversed ? key : key == kLower ? kUpper : key == kUpper ? kLower : key;
    const auto* const name = std::ranges::find_if(kNames, [ofAxis](const Name& one) { return one.key == ofAxis; });
    return name == std::end(kNames) ? QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()))
                                    : Text::tr(name->text);
}

}  // namespace boresight::drive_check

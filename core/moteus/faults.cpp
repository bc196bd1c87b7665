// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/faults.h"

#include <algorithm>
#include <array>

namespace boresight::moteus {
namespace {

struct Row
{
    int code = 0;
    FaultText text;
};

constexpr std::string_view kUartWires = "Disturbed or wrong wiring at an aux port";
constexpr std::string_view kUartSpeed = "A device at an aux port sends more, or at another speed, than configured";
constexpr std::string_view kCheckUart = "Power-cycle the drive; check the wiring and configuration of its aux ports";
constexpr std::string_view kWhileDemanded = "Nothing to clear; it ends when the demand falls";
constexpr std::string_view kBlocked = "A blocked axis, wrong gains, or a trajectory too fast for the torque allowed";
constexpr std::string_view kUnblock = "Free the axis, lower speed and acceleration or correct the gains, then re-arm";

// moteus register map version 5, firmware 1.1.0.
constexpr std::array kRows{
    Row{0, {"none", "No fault", "Nothing is wrong", "Nothing to do"}},
    Row{1, {"DMA transfer error", "The drive's internal data transfer failed", kUartWires, kCheckUart}},
    Row{2, {"DMA FIFO error", "The drive's internal data transfer lost data", kUartWires, kCheckUart}},
    Row{3, {"UART overrun", "The drive's aux UART received faster than it could read", kUartSpeed, kCheckUart}},
    Row{4, {"UART framing error", "The drive's aux UART received a malformed byte", kUartSpeed, kCheckUart}},
    Row{5, {"UART noise", "The drive's aux UART received noise", kUartWires, kCheckUart}},
    Row{6, {"UART buffer overrun", "The drive's aux UART buffer overflowed", kUartSpeed, kCheckUart}},
    Row{7, {"UART parity error", "The drive's aux UART received a damaged byte", kUartWires, kCheckUart}},
    Row{32,
        {"current sense calibration failed", "The zero of the current measurement could not be found when enabling",
         "The motor was turning while the drive was enabled, or the board is damaged",
         "Let the axis come to rest and re-arm; if it comes again, replace the board"}},
    Row{33,
        {"gate driver fault", "The gate driver of the motor outputs switched off",
         "Nearly always the supply sagged below the driver's limit; else damaged hardware",
         "Use a stronger supply or lower the drive's maximum power or current; if it comes again, read drv8323 with "
         "tview and replace the board"}},
    Row{34,
        {"over voltage", "The bus voltage rose above servo.max_voltage",
         "Braking fed the supply, which could not take it",
         "Lower the acceleration, set servo.max_regen_power_W, or "
         "add a battery or capacitance"}},
    Row{35,
        {"encoder fault", "The encoder's readings contradict each other or its port reports an error",
         "The magnet came loose, the air gap is wrong, or a wire is broken",
         "Check magnet, air gap, wiring and the aux port configuration"}},
    Row{36,
        {"motor not configured", "The drive has never been calibrated with its motor",
         "A new board, or its configuration was reset", "Run moteus_tool --calibrate with the axis free to turn"}},
    Row{37,
        {"control cycle overrun", "The drive's control loop did not finish in time", "An error of the drive's firmware",
         "Update the firmware and report it to the maker"}},
    Row{38,
        {"over temperature", "The board (75 °C by default) or the motor is too hot",
         "Too much torque for too long, or too little cooling",
         "Let it cool down; lower the torque or improve cooling"}},
    Row{39,
        {"outside position bounds", "The axis was outside servopos.position_min/max when motion was commanded",
         "Factory bounds of ±0.01 turns, a wrong turn after power-up, or an axis turned by hand",
         "Correct the bounds on the Protection page or bring the axis inside by hand, then re-arm"}},
    Row{40,
        {"under voltage", "The bus voltage fell below 4 V while driving", "The supply was switched off or cut",
         "Check supply, fuse and cable"}},
    Row{41,
        {"configuration changed", "A setting was changed while driving that requires a stop",
         "Another program wrote to the drive", "Close the other program, then re-arm"}},
    Row{42,
        {"no commutation angle", "No encoder gives the rotor angle", "Not calibrated, or the encoder is not connected",
         "Calibrate the motor or reconnect the encoder"}},
    Row{43,
        {"no output position", "No encoder gives the output position",
         "Not calibrated, or the encoder is not connected", "Calibrate the motor or reconnect the encoder"}},
    Row{44,
        {"gate driver would not enable", "The gate driver of the motor outputs could not be switched on",
         "The supply voltage is too low, or the board is damaged",
         "Check the supply at the board, at least 10 V; if it is right, replace the board"}},
    Row{45,
        {"stop position used with limits", "The deprecated stop position was commanded together with motion limits",
         "Another program commands the drive", "Close the other program, then re-arm"}},
    Row{46,
        {"timing violation", "The drive broke one of its internal timing checks",
         "An error of the drive's firmware, seen only with its checks enabled", "Report it to the maker"}},
    Row{47,
        {"feedforward without acceleration limit", "Back-EMF feedforward is on but no acceleration limit was in force",
         "servo.default_accel_limit is not set, or another program commands the drive",
         "Set servo.default_accel_limit on the Protection page, close other programs, then re-arm"}},
    Row{48,
        {"position bounds not representable", "servopos.position_min/max lie beyond ±32768 turns",
         "A slip in the drive's configuration", "Correct the bounds on the Protection page"}},
    Row{49, {"position error too large", "The axis fell too far behind its set-point", kBlocked, kUnblock}},
    Row{50, {"velocity error too large", "The axis turned at a speed too far from its set-point", kBlocked, kUnblock}},
    Row{96,
        {"limit: velocity", "Limited by servo.max_velocity", "A command faster than the drive allows", kWhileDemanded}},
    Row{97, {"limit: power", "Limited by servo.max_power_W", "Speed and torque are both high", kWhileDemanded}},
    Row{98,
        {"limit: bus voltage", "Limited by the voltage of the supply",
         "The motor would need more voltage for its speed",
         "Nothing to clear; check the supply if it is below its nominal voltage"}},
    Row{99,
        {"limit: current", "Limited by servo.max_current_A", "Wind, friction, a blocked axis or a high acceleration",
         kWhileDemanded}},
    Row{100,
        {"limit: board temperature", "Current reduced because the board is warm",
         "Much torque for a long time, or too little cooling",
         "It ends when the board cools down; fault 38 follows if it gets hotter"}},
    Row{101,
        {"limit: motor temperature", "Current reduced because the motor is warm",
         "Much torque for a long time, or too little cooling",
         "It ends when the motor cools down; fault 38 follows if it gets hotter"}},
    Row{102,
        {"limit: commanded torque", "Limited by the maximum torque of the command",
         "Wind, friction, a blocked axis or a high acceleration", kWhileDemanded}},
    Row{103,
        {"limit: position bounds", "Held back at servopos.position_min/max",
         "A place beyond the drive's own bounds was commanded, or the axis was pushed there",
         "Nothing to clear; move the other way or correct the bounds"}},
    Row{104,
        {"limit: flux braking", "Braking energy is burnt in the motor to hold the bus voltage",
         "The supply does not take back what braking feeds it",
         "Nothing to clear; lower the acceleration if it comes "
         "often"}},
    Row{105,
        {"limit: field weakening", "The field is weakened to reach the speed",
         "The motor would need more voltage for its speed", kWhileDemanded}},
};
static_assert(std::ranges::is_sorted(kRows, {}, &Row::code));

constexpr FaultText kUndefined{"undefined code", "The drive reports a code that register map 5 does not define",
                               "Firmware newer or older than this program knows",
                               "Compare the drive's firmware version with the one this program was made for"};

}  // namespace

FaultText faultText(int code)
{
    const auto found = std::ranges::lower_bound(kRows, code, {}, &Row::code);
    return found != kRows.end() && found->code == code ? found->text : kUndefined;
}

bool isLimit(int code)
{
    return code >= 96 && code <= 105;
}

bool needsStop(Mode mode)
{
    return mode == Mode::Fault || mode == Mode::PositionTimeout;
}

std::string_view modeText(Mode mode)
{
    static constexpr std::array<std::string_view, kModeCount> kTexts{"stopped",
                                                                     "fault",
                                                                     "enabling",
                                                                     "calibrating current sense",
                                                                     "calibration complete",
                                                                     "PWM",
                                                                     "voltage",
                                                                     "voltage FOC",
                                                                     "voltage DQ",
                                                                     "current",
                                                                     "position",
                                                                     "watchdog expired",
                                                                     "zero velocity",
                                                                     "stay within",
                                                                     "measuring inductance",
                                                                     "brake"};
    const auto index = static_cast<std::size_t>(mode);
    return index < kTexts.size() ? kTexts[index] : "undefined mode";
}

std::string_view homeStateText(HomeState state)
{
    switch (state) {
        case HomeState::Relative:
            return "not referenced";
        case HomeState::Rotor:
            return "referenced within one rotor turn";
        case HomeState::Output:
            return "output referenced";
    }
    return "undefined home state";
}

}  // namespace boresight::moteus

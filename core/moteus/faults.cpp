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

constexpr std::string_view kCheckUart = "Power-cycle the drive; check the wiring of its aux UART";
constexpr std::string_view kNothingToClear = "Nothing to clear; it ends when the demand falls";

// moteus register map version 5, firmware 1.1.0.
constexpr std::array kRows{
    Row{0, {"none", "No fault", "Nothing to do"}},
    Row{1, {"DMA transfer error", "The drive's internal data transfer failed", kCheckUart}},
    Row{2, {"DMA FIFO error", "The drive's internal data transfer lost data", kCheckUart}},
    Row{3, {"UART overrun", "The drive's aux UART received faster than it could read", kCheckUart}},
    Row{4, {"UART framing error", "The drive's aux UART received a malformed byte", kCheckUart}},
    Row{5, {"UART noise", "The drive's aux UART received noise", kCheckUart}},
    Row{6, {"UART buffer overrun", "The drive's aux UART buffer overflowed", kCheckUart}},
    Row{7, {"UART parity error", "The drive's aux UART received a damaged byte", kCheckUart}},
    Row{32,
        {"current sense calibration failed", "The zero of the current measurement could not be found when enabling",
         "Let the axis come to rest, send stop, try again; if it stays, the board is damaged"}},
    Row{33,
        {"gate driver fault", "The gate driver switched off, nearly always because the supply sagged",
         "Use a stronger supply or lower the drive's maximum power or current; other causes are hardware damage"}},
    Row{34,
        {"over voltage", "The bus voltage rose above servo.max_voltage",
         "Braking pumped the supply up: lower the acceleration, set servo.max_regen_power_W, add capacitance"}},
    Row{35,
        {"encoder fault", "The encoder's readings contradict each other or its port reports an error",
         "Check magnet, air gap, wiring and the aux port configuration"}},
    Row{36, {"motor not configured", "The drive has never been calibrated with its motor", "Run the calibration"}},
    Row{37,
        {"control cycle overrun", "The drive's control loop did not finish in time",
         "A firmware fault: update the firmware and report it"}},
    Row{38,
        {"over temperature", "The board (75 °C by default) or the motor is too hot",
         "Let it cool down; lower the torque or improve cooling"}},
    Row{39,
        {"outside position bounds", "The axis was outside servopos.position_min/max when motion was commanded",
         "Move the axis inside or correct the bounds, send stop, try again"}},
    Row{40, {"under voltage", "The bus voltage fell below 4 V while driving", "The supply was lost: check it"}},
    Row{41,
        {"configuration changed", "A setting was changed while driving that requires a stop",
         "Send stop, then command again"}},
    Row{42,
        {"no commutation angle", "No encoder gives the rotor angle", "Calibrate the motor or reconnect the encoder"}},
    Row{43,
        {"no output position", "No encoder gives the output position", "Calibrate the motor or reconnect the encoder"}},
    Row{44,
        {"gate driver would not enable", "The gate driver could not be switched on",
         "The supply voltage is too low, or the board is damaged"}},
    Row{45,
        {"stop position used with limits", "The deprecated stop position was commanded together with motion limits",
         "Do not use the stop position"}},
    Row{46,
        {"timing violation", "The drive broke one of its internal timing checks",
         "Only with checks enabled: report it to the maker"}},
    Row{47,
        {"feedforward without acceleration limit", "Back-EMF feedforward is on but no acceleration limit was sent",
         "Send an acceleration limit with every command"}},
    Row{48,
        {"position bounds not representable", "servopos.position_min/max lie outside the countable range",
         "Correct the bounds"}},
    Row{49,
        {"position error too large", "The axis fell too far behind its set-point",
         "Look for a blocked axis, wrong gains or too fast a trajectory"}},
    Row{50,
        {"velocity error too large", "The axis turned at a speed too far from its set-point",
         "Look for a blocked axis, wrong gains or too fast a trajectory"}},
    Row{96, {"limit: velocity", "Limited by servo.max_velocity", kNothingToClear}},
    Row{97, {"limit: power", "Limited by servo.max_power_W", kNothingToClear}},
    Row{98, {"limit: bus voltage", "Limited by the voltage of the supply", kNothingToClear}},
    Row{99, {"limit: current", "Limited by servo.max_current_A", kNothingToClear}},
    Row{100,
        {"limit: board temperature", "Current reduced because the board is warm",
         "It ends when the board cools down; fault 38 follows if it gets hotter"}},
    Row{101,
        {"limit: motor temperature", "Current reduced because the motor is warm",
         "It ends when the motor cools down; fault 38 follows if it gets hotter"}},
    Row{102, {"limit: commanded torque", "Limited by the maximum torque of the command", kNothingToClear}},
    Row{103,
        {"limit: position bounds", "Held back at servopos.position_min/max",
         "Nothing to clear; move the other way or correct the bounds"}},
    Row{104, {"limit: flux braking", "Braking energy is burnt in the motor to hold the bus voltage", kNothingToClear}},
    Row{105, {"limit: field weakening", "The field is weakened to reach the speed", kNothingToClear}},
};
static_assert(std::ranges::is_sorted(kRows, {}, &Row::code));

constexpr FaultText kUndefined{"undefined code", "The drive reports a code that register map 5 does not define",
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

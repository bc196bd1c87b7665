// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/faults.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>

namespace boresight::moteus {
namespace {

struct FaultRow
{
    int code = 0;
    FaultText text;
};

constexpr std::string_view kUartWires = QT_TRANSLATE_NOOP("Text", "Disturbed or wrong wiring at an aux port");
constexpr std::string_view kUartSpeed =
    QT_TRANSLATE_NOOP("Text", "A device at an aux port sends more data than configured, or at another speed");
constexpr std::string_view kCheckUart =
    QT_TRANSLATE_NOOP("Text", "Power-cycle the drive. Check the wiring and configuration of its aux ports");
constexpr std::string_view kWhileDemanded =
    QT_TRANSLATE_NOOP("Text", "There is nothing to clear. The limit ends when the load falls");
constexpr std::string_view kBlocked =
    QT_TRANSLATE_NOOP("Text", "A blocked axis, wrong gains, or a trajectory too fast for the torque allowed");
constexpr std::string_view kUnblock =
    QT_TRANSLATE_NOOP("Text", "Free the axis. Reduce speed and acceleration, or correct the gains. Then re-arm");

// moteus register map version 5, firmware 1.1.0.
constexpr std::array kRows{
    FaultRow{0,
             {"none", QT_TRANSLATE_NOOP("Text", "No fault"), QT_TRANSLATE_NOOP("Text", "Nothing is wrong"),
              QT_TRANSLATE_NOOP("Text", "Nothing to do")}},
    FaultRow{1,
             {"DMA transfer error", QT_TRANSLATE_NOOP("Text", "The drive's internal data transfer failed"), kUartWires,
              kCheckUart}},
    FaultRow{2,
             {"DMA FIFO error", QT_TRANSLATE_NOOP("Text", "The drive's internal data transfer lost data"), kUartWires,
              kCheckUart}},
    FaultRow{3,
             {"UART overrun", QT_TRANSLATE_NOOP("Text", "The drive's aux UART received faster than it could read"),
              kUartSpeed, kCheckUart}},
    FaultRow{4,
             {"UART framing error", QT_TRANSLATE_NOOP("Text", "The drive's aux UART received a malformed byte"),
              kUartSpeed, kCheckUart}},
    FaultRow{5,
             {"UART noise", QT_TRANSLATE_NOOP("Text", "The drive's aux UART received noise"), kUartWires, kCheckUart}},
    FaultRow{6,
             {"UART buffer overrun", QT_TRANSLATE_NOOP("Text", "The drive's aux UART buffer overflowed"), kUartSpeed,
              kCheckUart}},
    FaultRow{7,
             {"UART parity error", QT_TRANSLATE_NOOP("Text", "The drive's aux UART received a damaged byte"),
              kUartWires, kCheckUart}},
    FaultRow{32,
             {"current sense calibration failed",
              QT_TRANSLATE_NOOP("Text", "The zero of the current measurement could not be found when enabling"),
              QT_TRANSLATE_NOOP("Text", "The motor was turning while the drive was enabled, or the board is damaged"),
              QT_TRANSLATE_NOOP("Text",
                                "Wait until the axis stands still and re-arm. If the fault returns, replace the board"),
              true}},
    FaultRow{
        33,
        {"gate driver fault", QT_TRANSLATE_NOOP("Text", "The gate driver of the motor outputs switched off"),
         QT_TRANSLATE_NOOP("Text", "The supply fell below the limit of the gate driver, or the hardware is damaged"),
         QT_TRANSLATE_NOOP("Text",
                           "Use a stronger supply or lower the drive's maximum power or current. If the fault "
                           "returns, read drv8323 with tview and replace the board")}},
    FaultRow{34,
             {"over voltage", QT_TRANSLATE_NOOP("Text", "The bus voltage rose above servo.max_voltage"),
              QT_TRANSLATE_NOOP("Text", "Braking energy went into the supply. The supply could not absorb it"),
              QT_TRANSLATE_NOOP(
                  "Text", "Lower the acceleration, set servo.max_regen_power_W, or add a battery or capacitance")}},
    FaultRow{35,
             {"encoder fault",
              QT_TRANSLATE_NOOP("Text", "The encoder's readings contradict each other or its port reports an error"),
              QT_TRANSLATE_NOOP("Text", "The magnet came loose, the air gap is wrong, or a wire is broken"),
              QT_TRANSLATE_NOOP("Text", "Check magnet, air gap, wiring and the aux port configuration")}},
    FaultRow{36,
             {"motor not configured", QT_TRANSLATE_NOOP("Text", "The drive has never been calibrated with its motor"),
              QT_TRANSLATE_NOOP("Text", "A new board, or its configuration was reset"),
              QT_TRANSLATE_NOOP("Text", "Run moteus_tool --calibrate with the axis free to turn")}},
    FaultRow{37,
             {"control cycle overrun", QT_TRANSLATE_NOOP("Text", "The drive's control loop did not finish in time"),
              QT_TRANSLATE_NOOP("Text", "An error of the drive's firmware"),
              QT_TRANSLATE_NOOP("Text", "Update the firmware. Report the fault to the maker")}},
    FaultRow{38,
             {"over temperature", QT_TRANSLATE_NOOP("Text", "The board (75 °C by default) or the motor is too hot"),
              QT_TRANSLATE_NOOP("Text", "Too much torque for too long, or too little cooling"),
              QT_TRANSLATE_NOOP("Text", "Let it cool down. Lower the torque or improve the cooling")}},
    FaultRow{39,
             {"outside position bounds",
              QT_TRANSLATE_NOOP("Text", "The axis was outside servopos.position_min/max when motion was commanded"),
              QT_TRANSLATE_NOOP(
                  "Text", "Factory bounds of ±0.01 turns, a wrong cable wrap after power-up, or an axis moved by hand"),
              QT_TRANSLATE_NOOP(
                  "Text", "Correct the bounds on the Protection page or bring the axis inside by hand, then re-arm"),
              true}},
    FaultRow{40,
             {"under voltage", QT_TRANSLATE_NOOP("Text", "The bus voltage fell below 4 V while driving"),
              QT_TRANSLATE_NOOP("Text", "The supply was switched off or cut"),
              QT_TRANSLATE_NOOP("Text", "Check supply, fuse and cable")}},
    FaultRow{
        41,
        {"configuration changed", QT_TRANSLATE_NOOP("Text", "A setting that requires a stop was changed while driving"),
         QT_TRANSLATE_NOOP("Text", "Another program wrote to the drive"),
         QT_TRANSLATE_NOOP("Text", "Close the other program, then re-arm"), true}},
    FaultRow{42,
             {"no commutation angle", QT_TRANSLATE_NOOP("Text", "No encoder gives the rotor angle"),
              QT_TRANSLATE_NOOP("Text", "Not calibrated, or the encoder is not connected"),
              QT_TRANSLATE_NOOP("Text", "Calibrate the motor or reconnect the encoder")}},
    FaultRow{43,
             {"no output position", QT_TRANSLATE_NOOP("Text", "No encoder gives the output position"),
              QT_TRANSLATE_NOOP("Text", "Not calibrated, or the encoder is not connected"),
              QT_TRANSLATE_NOOP("Text", "Calibrate the motor or reconnect the encoder")}},
    FaultRow{44,
             {"gate driver would not enable",
              QT_TRANSLATE_NOOP("Text", "The gate driver of the motor outputs could not be switched on"),
              QT_TRANSLATE_NOOP("Text", "The supply voltage is too low, or the board is damaged"),
              QT_TRANSLATE_NOOP("Text",
                                "Check the supply at the board (at least 10 V). If it is right, replace the board")}},
    FaultRow{45,
             {"stop position used with limits",
              QT_TRANSLATE_NOOP("Text", "The deprecated stop position was commanded together with motion limits"),
              QT_TRANSLATE_NOOP("Text", "Another program commands the drive"),
              QT_TRANSLATE_NOOP("Text", "Close the other program, then re-arm"), true}},
    FaultRow{46,
             {"timing violation", QT_TRANSLATE_NOOP("Text", "An internal timing check of the drive failed"),
              QT_TRANSLATE_NOOP("Text", "An error of the drive's firmware, detected only with its checks enabled"),
              QT_TRANSLATE_NOOP("Text", "Report the fault to the maker")}},
    FaultRow{47,
             {"feedforward without acceleration limit",
              QT_TRANSLATE_NOOP("Text", "Back-EMF feedforward is on but no acceleration limit was in force"),
              QT_TRANSLATE_NOOP("Text", "servo.default_accel_limit is not set, or another program commands the drive"),
              QT_TRANSLATE_NOOP(
                  "Text", "Set servo.default_accel_limit on the Protection page, close other programs, then re-arm"),
              true}},
    FaultRow{48,
             {"position bounds not representable",
              QT_TRANSLATE_NOOP("Text", "servopos.position_min/max lie beyond ±32768 turns"),
              QT_TRANSLATE_NOOP("Text", "A mistake in the drive's configuration"),
              QT_TRANSLATE_NOOP("Text", "Correct the bounds on the Protection page")}},
    FaultRow{49,
             {"position error too large", QT_TRANSLATE_NOOP("Text", "The axis fell too far behind its set-point"),
              kBlocked, kUnblock, true}},
    FaultRow{
        50,
        {"velocity error too large", QT_TRANSLATE_NOOP("Text", "The axis turned at a speed too far from its set-point"),
         kBlocked, kUnblock, true}},
    FaultRow{96,
             {"limit: velocity", QT_TRANSLATE_NOOP("Text", "Limited by servo.max_velocity"),
              QT_TRANSLATE_NOOP("Text", "A command faster than the drive allows"), kWhileDemanded}},
    FaultRow{97,
             {"limit: power", QT_TRANSLATE_NOOP("Text", "Limited by servo.max_power_W"),
              QT_TRANSLATE_NOOP("Text", "Speed and torque are both high"), kWhileDemanded}},
    FaultRow{
        98,
        {"limit: bus voltage", QT_TRANSLATE_NOOP("Text", "Limited by the voltage of the supply"),
         QT_TRANSLATE_NOOP("Text", "The motor would need more voltage for its speed"),
         QT_TRANSLATE_NOOP("Text", "There is nothing to clear. Check the supply if it is below its nominal voltage")}},
    FaultRow{99,
             {"limit: current", QT_TRANSLATE_NOOP("Text", "Limited by servo.max_current_A"),
              QT_TRANSLATE_NOOP("Text", "Wind, friction, a blocked axis or a high acceleration"), kWhileDemanded}},
    FaultRow{100,
             {"limit: board temperature", QT_TRANSLATE_NOOP("Text", "Current reduced because the board is warm"),
              QT_TRANSLATE_NOOP("Text", "Much torque for a long time, or too little cooling"),
              QT_TRANSLATE_NOOP(
                  "Text", "The limit ends when the board cools down. If the board gets hotter, fault 38 follows")}},
    FaultRow{101,
             {"limit: motor temperature", QT_TRANSLATE_NOOP("Text", "Current reduced because the motor is warm"),
              QT_TRANSLATE_NOOP("Text", "Much torque for a long time, or too little cooling"),
              QT_TRANSLATE_NOOP(
                  "Text", "The limit ends when the motor cools down. If the motor gets hotter, fault 38 follows")}},
    FaultRow{102,
             {"limit: commanded torque", QT_TRANSLATE_NOOP("Text", "Limited by the maximum torque of the command"),
              QT_TRANSLATE_NOOP("Text", "Wind, friction, a blocked axis or a high acceleration"), kWhileDemanded}},
    FaultRow{103,
             {"limit: position bounds", QT_TRANSLATE_NOOP("Text", "Limited by servopos.position_min/max"),
              QT_TRANSLATE_NOOP("Text",
                                "A position beyond the drive's own bounds was commanded, or the axis was pushed there"),
              QT_TRANSLATE_NOOP("Text", "There is nothing to clear. Move the other way or correct the bounds")}},
    FaultRow{104,
             {"limit: flux braking",
              QT_TRANSLATE_NOOP(
                  "Text", "The motor turns braking energy into heat, so that the bus voltage stays in its limits"),
              QT_TRANSLATE_NOOP("Text", "The supply does not absorb the braking energy"),
              QT_TRANSLATE_NOOP("Text", "There is nothing to clear. If this happens often, lower the acceleration")}},
    FaultRow{105,
             {"limit: field weakening", QT_TRANSLATE_NOOP("Text", "The drive weakens the field to reach the speed"),
              QT_TRANSLATE_NOOP("Text", "The motor would need more voltage for its speed"), kWhileDemanded}},
};
static_assert(std::ranges::is_sorted(kRows, {}, &FaultRow::code));

constexpr FaultText kUndefined{
    "undefined code", QT_TRANSLATE_NOOP("Text", "The drive reports a code that register map 5 does not define"),
    QT_TRANSLATE_NOOP("Text", "Firmware that Boresight does not support"),
    QT_TRANSLATE_NOOP("Text",
                      "Compare the firmware version of the drive with the version that this program was made for")};

}  // namespace

FaultText faultText(int code)
{
    const auto found = std::ranges::lower_bound(kRows, code, {}, &FaultRow::code);
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
    static constexpr std::array<std::string_view, kModeCount> kTexts{
        QT_TRANSLATE_NOOP("Text", "stopped"),
        QT_TRANSLATE_NOOP("Text", "fault"),
        QT_TRANSLATE_NOOP("Text", "enabling"),
        QT_TRANSLATE_NOOP("Text", "calibrating current sense"),
        QT_TRANSLATE_NOOP("Text", "calibration complete"),
        QT_TRANSLATE_NOOP("Text", "PWM"),
        QT_TRANSLATE_NOOP("Text", "voltage"),
        QT_TRANSLATE_NOOP("Text", "voltage FOC"),
        QT_TRANSLATE_NOOP("Text", "voltage DQ"),
        QT_TRANSLATE_NOOP("Text", "current"),
        QT_TRANSLATE_NOOP("Text", "position"),
        QT_TRANSLATE_NOOP("Text", "watchdog expired"),
        QT_TRANSLATE_NOOP("Text", "zero velocity"),
        QT_TRANSLATE_NOOP("Text", "stay within"),
        QT_TRANSLATE_NOOP("Text", "measuring inductance"),
        QT_TRANSLATE_NOOP("Text", "brake")};
    const auto index = static_cast<std::size_t>(mode);
    return index < kTexts.size() ? kTexts[index] : QT_TRANSLATE_NOOP("Text", "undefined mode");
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

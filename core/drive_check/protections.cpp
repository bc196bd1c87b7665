// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/protections.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/contacts/output_name.h"
#include "core/drive_check/setting_names.h"
#include "core/moteus/pin_query.h"
#include "core/tracking/emergency_braking.h"

#include <algorithm>
#include <cmath>

namespace boresight::drive_check {
namespace {

using List = std::vector<Protection>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kTimeoutDamp = 12;
constexpr int kTimeoutBrake = 15;

QString number(double value)
{
    return std::isnan(value) ? Text::tr("none") : QString::number(value, 'g', 6);
}

// For the operator: the drive keeps six decimals of a turn, and 10° would read back as 10.0001°.
QString rounded(double value)
{
    return std::abs(value) >= 1000.0 ? QString::number(value, 'f', 0) : QString::number(value, 'g', 3);
}

QString degrees(double value)
{
    return QString::number(value, 'f', 1) + QStringLiteral("°");
}

bool isWithin(double value, double least, double most)
{
    return value >= least && value <= most;
}

// Converts angles of an axis into turns of its drive.
struct DriveScale
{
    const pointing::AxisGeometry& geometry;

    [[nodiscard]] double turns(Angle span) const
    {
        return abs(geometry.toMotor(span) - geometry.toMotor(Angle{})).turns();
    }
    [[nodiscard]] double lower() const
    {
        return std::min(geometry.toMotor(geometry.travel.min), geometry.toMotor(geometry.travel.max)).turns();
    }
    [[nodiscard]] double upper() const
    {
        return std::max(geometry.toMotor(geometry.travel.min), geometry.toMotor(geometry.travel.max)).turns();
    }
    [[nodiscard]] std::function<QString(double)> asAngle() const
    {
        return [g = geometry](double turns) { return degrees(g.toAxis(MotorTurns::fromTurns(turns)).degrees()); };
    }
    [[nodiscard]] std::function<QString(double)> asSpan(const QString& unit) const
    {
        return [perDegree = turns(Angle::fromDegrees(1.0)), unit](double turns) {
            return rounded(turns / perDegree) + unit;
        };
    }
    // "10 to 20°/s", from turns per second.
    [[nodiscard]] QString angles(double least, double most, const QString& unit) const
    {
        const double perDegree = turns(Angle::fromDegrees(1.0));
        return Text::tr("%1 to %2%3").arg(rounded(least / perDegree), rounded(most / perDegree), unit);
    }
    // "0.0278 to 0.0556 turns/s (10 to 20°/s)".
    [[nodiscard]] QString range(double least, double most, const QString& unit, const QString& ofAngle) const
    {
        return Text::tr("%1 to %2 %3 (%4)").arg(rounded(least), rounded(most), unit, angles(least, most, ofAngle));
    }
};

QString shown(const Protection& protection, double value)
{
    QString text = number(value);
    if (!std::isnan(value) && !protection.unit.isEmpty()) {
        text += QLatin1Char(' ') + protection.unit;
    }
    const bool explains = protection.explain && std::isfinite(value);
    return explains ? QStringLiteral("%1 (%2)").arg(text, protection.explain(value)) : text;
}

QString brief(const Protection& protection, double value)
{
    return protection.isAngle && std::isfinite(value) ? protection.explain(value) : shown(protection, value);
}

// Without a text for the wanted value, the value that Fix writes is shown as the wanted one.
void addWithRemedy(List& list, Protection protection)
{
    if (protection.wanted.isEmpty() && protection.remedy) {
        protection.wanted = shown(protection, *protection.remedy);
        protection.wantedBrief = brief(protection, *protection.remedy);
    }
    list.push_back(std::move(protection));
}

QString boundConsequence(double found, bool narrow)
{
    constexpr double kFactoryBound = 0.01;
    if (std::isnan(found)) {
        return Text::tr("The drive has no limit of its own. Only Boresight ends a motion.");
    }
    if (std::abs(std::abs(found) - kFactoryBound) < 1e-6) {
        return Text::tr("The factory limits are ±3.6°. With them every motion ends in fault 39.");
    }
    return narrow ? Text::tr(
                        "The limit lies inside the travel. The drive stops with fault 39 where the profile permits "
                        "motion.")
                  : Text::tr("The limit is too far out. The cable or the frame stops the axis before the drive does.");
}

// `outwards`: +1 for the upper bound. At least half the margin, so that the axis can settle at the end of its travel.
void addBound(List& list, const profile::Profile& profile, const DriveScale& scale, const std::string& key,
              double travelEnd, double outwards)
{
    const Angle margin = profile.control.driveLimitMargin;
    const double nearest = scale.turns(0.5 * margin);
    const double farthest = scale.turns(margin + 1.0_deg);
    const auto beyond = [=](double found) { return outwards * (found - travelEnd); };
    addWithRemedy(list, {.key = key,
                         .unit = Text::tr("turns"),
                         .isRight = [=](double found) { return isWithin(beyond(found), nearest, farthest); },
                         .otherwise = Verdict::Dangerous,
                         .remedy = travelEnd + outwards * scale.turns(margin),
                         .reason = Text::tr("The drive stops the axis here by itself, a little beyond the travel."),
                         .consequence = [=](double found) { return boundConsequence(found, beyond(found) < nearest); },
                         .explain = scale.asAngle(),
                         .isAngle = true,
                         .reversed = scale.geometry.sign < 0});
}

void addIdentity(List& list, const profile::AxisSettings& axis)
{
    list.push_back({.key = "id.id",
                    .wanted = number(axis.id),
                    .isRight = [id = axis.id](double found) { return found == id; },
                    .otherwise = Verdict::Dangerous,
                    .reason = Text::tr("The profile has this id for this axis.")});
}

QString timeoutModeConsequence(double found)
{
    if (found == kTimeoutDamp) {
        return Text::tr("Mode 12 only damps. Without commands a loaded elevation creeps down.");
    }
    if (found == 0.0) {
        return Text::tr("Mode 0 switches the motor off. Without commands the axis is free.");
    }
    if (found == kTimeoutBrake) {
        return Text::tr(
            "Mode 15 brakes but does not hold. It is right only for a self-locking gearbox (timeout_mode = \"brake\" "
            "in the profile).");
    }
    return found == kTimeoutHold ? Text::tr("The profile has a self-locking gearbox, so it asks for brake (15).")
                                 : Text::tr("This mode is not safe for a drive without commands.");
}

QString timeoutModeWord(double mode)
{
    switch (static_cast<int>(mode)) {
        case 0:
            return Text::tr("off");
        case kTimeoutHold:
            return Text::tr("hold");
        case kTimeoutDamp:
            return Text::tr("damp");
        case kTimeoutBrake:
            return Text::tr("brake");
        default:
            return Text::tr("unknown");
    }
}

void addTimeout(List& list, const profile::ControlSettings& control, const profile::AxisSettings& axis)
{
    const bool holds = axis.timeoutMode == profile::TimeoutMode::Hold;
    const int mode = holds ? kTimeoutHold : kTimeoutBrake;
    addWithRemedy(list, {.key = "servo.timeout_mode",
                         .isRight = [mode](double found) { return found == mode; },
                         .otherwise = Verdict::Dangerous,
                         .remedy = mode,
                         .reason = holds ? Text::tr("Without commands the drive brakes by itself, then holds.")
                                         : Text::tr("Without commands the drive brakes by itself."),
                         .consequence = timeoutModeConsequence,
                         .explain = timeoutModeWord});
    addWithRemedy(list, {.key = "servo.default_timeout_s",
                         .unit = QStringLiteral("s"),
                         .wanted = Text::tr("0.05 to 0.2 s"),
                         .isRight = [](double found) { return isWithin(found, 0.05, 0.2); },
                         .otherwise = Verdict::Dangerous,
                         .remedy = control.watchdog.count(),
                         .reason = Text::tr("After this time without a command the drive stops by itself.")});
    addWithRemedy(list, {.key = "servo.timeout_max_torque_Nm",
                         .unit = QStringLiteral("Nm"),
                         .wanted = Text::tr("above 0 Nm"),
                         .isRight = [](double found) { return found > 0.0; },
                         .remedy = std::min(5.0, axis.maxTorque),  // 5 Nm is the factory default
                         .reason = Text::tr("Timeout mode 12 damps with this torque.")});
}

void addElectrical(List& list)
{
    list.push_back({.key = "servo.max_current_A",
                    .unit = QStringLiteral("A"),
                    .wanted = Text::tr("above 0 A"),
                    .isRight = [](double found) { return found > 0.0 && std::isfinite(found); },
                    .otherwise = Verdict::Dangerous,
                    .reason = Text::tr("Without current the axis falls. Without a limit the motor burns. The value is "
                                       "in the data sheet of the motor.")});
    addWithRemedy(
        list,
        {.key = "servo.max_voltage",
         .unit = QStringLiteral("V"),
         .wanted = Text::tr("10 to 46 V"),
         .isRight = [](double found) { return isWithin(found, 10.0, 46.0); },
         .otherwise = Verdict::Dangerous,
         .remedy = 46.0,  // factory default, for a board of 44 V
         .reason = Text::tr("Above this voltage the drive stops, so that braking energy cannot destroy the board.")});
    addWithRemedy(list,
                  {.key = "servo.flux_brake_margin_voltage",
                   .unit = QStringLiteral("V"),
                   .wanted = Text::tr("1 to 20 V"),
                   .isRight = [](double found) { return isWithin(found, 1.0, 20.0); },
                   .remedy = 3.0,  // factory default
                   .reason = Text::tr(
                       "At this distance below servo.max_voltage the motor begins to turn braking energy into heat.")});
}

void addLimits(List& list, const profile::AxisSettings& axis, const DriveScale& scale)
{
    const double speed = scale.turns(Angle::fromDegrees(axis.limits.speed.degrees()));
    addWithRemedy(
        list,
        {.key = "servo.default_velocity_limit",
         .unit = Text::tr("turns/s"),
         .wanted = scale.range(speed, 2.0 * speed, Text::tr("turns/s"), QStringLiteral("°/s")),
         .wantedBrief = scale.angles(speed, 2.0 * speed, QStringLiteral("°/s")),
         .isRight = [speed](double found) { return isWithin(found, speed, 2.0 * speed); },
         .remedy = tracking::kLimitGuard * speed,
         .reason = Text::tr("The highest speed of a command that has no speed of its own. The factory sets no limit."),
         .explain = scale.asSpan(QStringLiteral("°/s")),
         .isAngle = true});
    const double braking = scale.turns(Angle::fromDegrees(tracking::emergencyBraking(axis.limits).degrees()));
    const double lowest = 0.8 * braking;  // stops within 0.1 s from full speed
    addWithRemedy(list,
                  {.key = "servo.default_accel_limit",
                   .unit = Text::tr("turns/s²"),
                   .wanted = scale.range(lowest, 2.0 * braking, Text::tr("turns/s²"), QStringLiteral("°/s²")),
                   .wantedBrief = scale.angles(lowest, 2.0 * braking, QStringLiteral("°/s²")),
                   .isRight = [=](double found) { return isWithin(found, lowest, 2.0 * braking); },
                   .remedy = braking,
                   .reason = Text::tr("Without commands the drive brakes with this deceleration. Too low: the axis "
                                      "runs on. Too high (factory: 50 turns/s²): the stop shakes the mount."),
                   .explain = scale.asSpan(QStringLiteral("°/s²")),
                   .isAngle = true});
}

void addGear(List& list, const profile::AxisSettings& axis)
{
    const double ratio = axis.geometry.gearIn == pointing::GearIn::Drive ? 1.0 / axis.geometry.gearRatio : 1.0;
    list.push_back({.key = "motor_position.rotor_to_output_ratio",
                    .wanted = number(ratio),
                    // The drive writes six decimals.
                    .isRight = [ratio](double found) { return std::abs(found - ratio) <= 1e-6 + 1e-4 * ratio; },
                    .otherwise = Verdict::Dangerous,
                    .reason = Text::tr(
                        "The gear ratio of the profile (gear_ratio, gear_in). With another ratio every angle is wrong. "
                        "Press Set gear to write the ratio of the profile. Boresight also changes the gains.")});
    list.push_back(
        {.key = "motor_position.output.sign",
         .wanted = Text::tr("1 or -1"),
         .isRight = [](double found) { return found == 1.0 || found == -1.0; },
         .otherwise = Verdict::Dangerous,
         .reason =
             Text::tr("With the other sign the axis turns the other way. Then change the sign in the profile, too.")});
    const bool needed = axis.powerUpPosition == profile::PowerUpPosition::Trusted && axis.geometry.gearRatio > 1.0;
    list.push_back(
        {.key = "motor_position.output.reference_source",
         .wanted = needed ? Text::tr("0 or above") : Text::tr("any"),
         .isRight = [needed](double found) { return found >= (needed ? 0.0 : -1.0); },
         .reason =
             needed ? Text::tr("The profile trusts the position after power-up (power_up_position), but the drive has "
                               "no encoder on the axis.")
                    : Text::tr("-1: the drive has no encoder on the axis. After power-up the cable wrap is unknown.")});
}

void addSecondLines(List& list, const DriveScale& scale)
{
    const double least = scale.turns(2.0_deg);
    const double most = scale.turns(20.0_deg);
    addWithRemedy(list, {.key = "servo.fault_position_error",
                         .unit = Text::tr("turns"),
                         .wanted = scale.range(least, most, Text::tr("turns"), QStringLiteral("°")),
                         .wantedBrief = scale.angles(least, most, QStringLiteral("°")),
                         .isRight = [=](double found) { return isWithin(found, least, most); },
                         .remedy = scale.turns(10.0_deg),
                         .reason = Text::tr("With a larger position error the drive stops with fault 49. This protects "
                                            "a blocked axis even without Boresight."),
                         .explain = scale.asSpan(QStringLiteral("°")),
                         .isAngle = true});
    const double slip = scale.turns(1.0_deg);
    addWithRemedy(list, {.key = "servo.max_position_slip",
                         .unit = Text::tr("turns"),
                         .wanted = Text::tr("none or ≥ 1°"),
                         .isRight = [slip](double found) { return std::isnan(found) || found >= slip; },
                         .remedy = kNone,
                         .reason = Text::tr("With a small value the wind can push the axis away."),
                         .explain = scale.asSpan(QStringLiteral("°")),
                         .isAngle = true});
}

// The pin of the brakes shows what Boresight writes only in this mode. Another mode may have another use of the pin, so
// a person has to change it.
void addBrakePin(List& list, const profile::Profile& profile, int board)
{
    const auto output = contacts::parseOutput(profile.brake.output);
    if (!output || output->kind != contacts::OutputKind::Pin || output->pin.board != board) {
        return;
    }
    const std::string key =
        "aux" + std::to_string(output->pin.port) + ".pins." + std::to_string(output->pin.number) + ".mode";
    list.push_back({.key = key,
                    .wanted = Text::tr("%1 (output)").arg(moteus::kDigitalOutput),
                    .isRight = [](double found) { return found == moteus::kDigitalOutput; },
                    .otherwise = Verdict::Dangerous,
                    .reason = Text::tr("This pin releases the brakes (brake.output), so it must be an output. Set it "
                                       "with moteus tview: conf set %1 %2; conf write.")
                                  .arg(toQString(key))
                                  .arg(moteus::kDigitalOutput)});
}

}  // namespace

std::optional<double> Reading::value() const
{
    if (state != State::Read) {
        return std::nullopt;
    }
    return text == "nan" || text == "-nan" ? std::optional(kNone) : parseFinite(text);
}

std::vector<Protection> protectionsOf(const profile::Profile& profile, Axis which)
{
    const profile::AxisSettings& axis = profile.axis(which);
    const DriveScale scale{axis.geometry};
    List list;
    addIdentity(list, axis);
    addBound(list, profile, scale, "servopos.position_min", scale.lower(), -1.0);
    addBound(list, profile, scale, "servopos.position_max", scale.upper(), 1.0);
    addTimeout(list, profile.control, axis);
    addElectrical(list);
    addLimits(list, axis, scale);
    addGear(list, axis);
    addSecondLines(list, scale);
    addBrakePin(list, profile, axis.id);
    return list;
}

QString foundText(const Protection& protection, const Reading& reading)
{
    switch (reading.state) {
        case Reading::State::Unread:
            return {};
        case Reading::State::Unknown:
            return Text::tr("not known to this firmware");
        case Reading::State::Read:
            break;
    }
    const std::optional<double> value = reading.value();
    return value ? shown(protection, *value) : QStringLiteral("\"%1\"").arg(QString::fromStdString(reading.text));
}

ProtectionLine judged(const Protection& protection, const Reading& reading)
{
    ProtectionLine line{.key = QString::fromStdString(protection.key),
                        .name = settingName(protection.key, protection.reversed),
                        .wanted = protection.wanted,
                        .found = foundText(protection, reading),
                        .wantedBrief = protection.wantedBrief.isEmpty() ? protection.wanted : protection.wantedBrief,
                        .reason = protection.reason};
    if (reading.state == Reading::State::Unread) {
        return line;
    }
    const std::optional<double> value = reading.value();
    line.foundBrief = value ? brief(protection, *value) : line.found;
    const bool right = value && protection.isRight(*value);
    line.verdict = right ? Verdict::Right : protection.otherwise;
    if (value && !right && protection.consequence) {
        line.reason = protection.consequence(*value);
    }
    if (!right && protection.remedy && reading.state == Reading::State::Read) {
        line.fix = shown(protection, *protection.remedy);
    }
    return line;
}

std::string settingText(double value)
{
    return std::isnan(value) ? "nan" : formatFixed(value, 6);
}

// The drive computes in single precision and writes six decimals.
bool tookEffect(double written, const Reading& reading)
{
    const std::optional<double> value = reading.value();
    if (!value || std::isnan(written) || std::isnan(*value)) {
        return value && std::isnan(written) && std::isnan(*value);
    }
    return std::abs(*value - written) <= 1e-6 + 1e-5 * std::abs(written);
}

QString axisName(Axis axis)
{
    return axis == Axis::Azimuth ? QStringLiteral("azimuth") : QStringLiteral("elevation");
}

QString axisText(Axis axis)
{
    return axis == Axis::Azimuth ? Text::tr("azimuth") : Text::tr("elevation");
}

}  // namespace boresight::drive_check

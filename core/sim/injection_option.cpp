// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/injection_option.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/moteus/faults.h"
#include "core/sim/reply_spoiler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::sim {
namespace {

constexpr auto kNeeded = NeedOfValue::Needed;
constexpr auto kOptional = NeedOfValue::Optional;

constexpr std::array<InjectionOption, 32> kOptions{{
    {.name = "silence", .kind = FaultKind::Silence, .text = "obeys commands but does not reply"},
    {.name = "late",
     .kind = FaultKind::LateReply,
     .need = kNeeded,
     .value = "TIME",
     .unit = "s",
     .max = 10.0,
     .text = "replies # late"},
    {.name = "lose",
     .kind = FaultKind::LostReply,
     .need = kNeeded,
     .value = "P",
     .max = 1.0,
     .text = "loses its replies with probability #"},
    {.name = "lose-command",
     .kind = FaultKind::LostCommand,
     .need = kNeeded,
     .value = "P",
     .max = 1.0,
     .text = "does not receive a frame with probability # (1 is a cut cable)"},
    {.name = "corrupt",
     .kind = FaultKind::CorruptLine,
     .need = kNeeded,
     .value = "P",
     .max = 1.0,
     .text = "damages its replies with probability #"},
    {.name = "duplicate-id", .kind = FaultKind::DuplicateId, .text = "has the id of the other drive"},
    {.name = "false-position",
     .kind = FaultKind::FalsePosition,
     .need = kNeeded,
     .value = "DEGREES",
     .unit = "deg",
     .min = -36000.0,
     .max = 36000.0,
     .text = "the position in its replies is wrong by #"},
    {.name = "position-nan", .kind = FaultKind::PositionNaN, .text = "the position in its replies is NaN"},
    {.name = "position-infinite",
     .kind = FaultKind::PositionInfinite,
     .text = "the position in its replies is infinite"},
    {.name = "position-missing", .kind = FaultKind::PositionMissing, .text = "its replies end before the position"},
    {.name = "supply-nan", .kind = FaultKind::SupplyNaN, .text = "the supply voltage in its replies is NaN"},
    {.name = "temperature-nan", .kind = FaultKind::TemperatureNaN, .text = "the temperatures in its replies are NaN"},
    {.name = "answer-as",
     .kind = FaultKind::ForeignId,
     .need = kNeeded,
     .value = "ID",
     .min = 0.0,
     .max = 127.0,
     .whole = true,
     .text = "its replies carry the id #"},
    {.name = "exchange", .kind = FaultKind::ExchangedReplies, .text = "its replies carry the id of the other drive"},
    {.name = "double", .kind = FaultKind::DoubledReply, .text = "each of its replies comes twice"},
    {.name = "stale",
     .kind = FaultKind::StaleReply,
     .need = kNeeded,
     .value = "TIME",
     .unit = "s",
     .max = kLongestStale.count(),
     .text = "repeats its reply of # ago"},
    {.name = "edit",
     .kind = FaultKind::EditedReply,
     .need = kNeeded,
     .value = "P",
     .max = 1.0,
     .text = "changes its replies at random with probability #: false, missing, stale, doubled, under another id"},
    {.name = "slip",
     .kind = FaultKind::EncoderSlip,
     .need = kNeeded,
     .value = "DEGREES",
     .unit = "deg",
     .min = -360.0,
     .max = 360.0,
     .text = "its encoder slips by # once"},
    {.name = "fault",
     .kind = FaultKind::DriveFault,
     .need = kNeeded,
     .value = "CODE",
     .min = 1.0,
     .max = 255.0,
     .whole = true,
     .text = "drive fault #. If the fault is cleared before it ends, it returns when the drive is switched on. 96…105: "
             "limits that the drive reports while it works"},
    {.name = "wind",
     .kind = FaultKind::Wind,
     .need = kNeeded,
     .value = "TORQUE",
     .unit = "Nm",
     .min = -10000.0,
     .max = 10000.0,
     .text = "wind of # towards larger angles"},
    {.name = "jam",
     .kind = FaultKind::Jam,
     .need = kNeeded,
     .value = "DEGREES",
     .unit = "deg",
     .min = -720.0,
     .max = 720.0,
     .text = "blocked at #"},
    {.name = "stall", .kind = FaultKind::Stall, .text = "blocked at its present place"},
    {.name = "register-map",
     .kind = FaultKind::RegisterMap,
     .need = kNeeded,
     .value = "VERSION",
     .max = 1000.0,
     .whole = true,
     .text = "reports register map version #"},
    {.name = "board-power-loss", .kind = FaultKind::BoardPowerLoss, .text = "the drive has no power"},
    {.name = "power-loss",
     .kind = FaultKind::PowerLoss,
     .need = kOptional,
     .value = "DEGREES",
     .unit = "deg",
     .min = -720.0,
     .max = 720.0,
     .text = "the mount has no power. Somebody turns it to # by hand"},
    {.name = "supply",
     .kind = FaultKind::SupplyVoltage,
     .need = kNeeded,
     .value = "VOLTAGE",
     .unit = "V",
     .max = 60.0,
     .takesAxis = false,
     .text = "the supply has #"},
    {.name = "missing-ok",
     .kind = FaultKind::MissingOk,
     .takesAxis = false,
     .ofAdapter = true,
     .text = "the adapter acknowledges nothing"},
    {.name = "adapter-error",
     .kind = FaultKind::AdapterError,
     .takesAxis = false,
     .ofAdapter = true,
     .text = "the adapter answers ERR and sends nothing"},
    {.name = "bus-off",
     .kind = FaultKind::BusOff,
     .takesAxis = false,
     .ofAdapter = true,
     .text = "the adapter is off the bus"},
    {.name = "sensor-silence", .kind = FaultKind::SensorSilence, .takesAxis = false, .text = "the sensor has no power"},
    {.name = "sensor-dead",
     .kind = FaultKind::SensorDead,
     .takesAxis = false,
     .text = "the chip of the sensor does not answer, so the sensor sends zeros"},
    {.name = "sensor-frozen",
     .kind = FaultKind::SensorFrozen,
     .takesAxis = false,
     .text = "the sensor repeats one value"},
}};

std::string arguments(const InjectionOption& option)
{
    const std::string axis = option.takesAxis ? "[AXIS]" : "";
    const std::string axisBefore = option.takesAxis ? "[AXIS:]" : "";
    const std::string times = "[@START][+DURATION]";
    switch (option.need) {
        case NeedOfValue::None:
            return axis + times;
        case NeedOfValue::Optional:
            return axis + "[:" + std::string(option.value) + ']' + times;
        case NeedOfValue::Needed:
            break;
    }
    return axisBefore + std::string(option.value) + times;
}

constexpr double kLongestTime = 86400.0;  // s

// For example "5", "5s" or "500ms", up to a day.
std::optional<double> readTime(std::string_view text)
{
    double factor = 1.0;
    if (text.ends_with("ms")) {
        factor = 1.0e-3;
        text.remove_suffix(2);
    } else if (text.ends_with('s')) {
        text.remove_suffix(1);
    }
    const std::optional<double> number = parseFinite(text);
    const bool isTime = number && *number >= 0.0 && *number * factor <= kLongestTime;
    return isTime ? std::optional(*number * factor) : std::nullopt;
}

std::optional<double> readNumber(const InjectionOption& option, std::string_view text)
{
    if (option.unit == "s") {
        return readTime(text);
    }
    if (!option.unit.empty() && text.ends_with(option.unit)) {
        text.remove_suffix(option.unit.size());
    }
    return parseFinite(text);
}

std::string numberText(double value)
{
    std::string text = formatFixed(value, 3);
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

// The parts of an option's text: az : 30 @ 5 + 3.
struct Parts
{
    std::optional<Axis> axis{};
    std::string_view value;
    std::optional<std::string_view> start{};
    std::optional<std::string_view> duration{};
};

Parts split(std::string_view text)
{
    Parts parts;
    if (const std::size_t plus = text.find('+'); plus != std::string_view::npos) {
        parts.duration = text.substr(plus + 1);
        text = text.substr(0, plus);
    }
    if (const std::size_t at = text.find('@'); at != std::string_view::npos) {
        parts.start = text.substr(at + 1);
        text = text.substr(0, at);
    }
    const std::string_view head = text.substr(0, text.find(':'));
    if (head == "az" || head == "el") {
        parts.axis = head == "az" ? Axis::Azimuth : Axis::Elevation;
        text.remove_prefix(std::min(head.size() + 1, text.size()));
    }
    parts.value = text;
    return parts;
}

// Each check stores its part in the injection and returns what is wrong with it. Empty: nothing is wrong.
QString takeAxis(const InjectionOption& option, const Parts& parts, Injection& injection)
{
    injection.axis = parts.axis;
    return parts.axis && !option.takesAxis ? QStringLiteral("concerns both axes. Leave out the axis") : QString();
}

QString takeValue(const InjectionOption& option, const Parts& parts, Injection& injection)
{
    std::string text(parts.value);
    if (option.need == kOptional && !parts.axis && text.starts_with(':')) {
        text.erase(0, 1);  // the form "[AXIS][:VALUE]" without an axis
    }
    if (text.empty()) {
        return option.need == kNeeded ? QStringLiteral("the value is missing") : QString();
    }
    if (option.need == NeedOfValue::None) {
        return QStringLiteral("\"%1\" is not an axis. Write az or el. This option has no value").arg(toQString(text));
    }
    injection.value = readNumber(option, text);
    if (!injection.value) {
        return (option.unit == "s" ? QStringLiteral("\"%1\" is not a time") : QStringLiteral("\"%1\" is not a number"))
            .arg(toQString(text));
    }
    if (*injection.value < option.min || *injection.value > option.max ||
        (option.whole && std::trunc(*injection.value) != *injection.value)) {
        return (option.whole ? QStringLiteral("%1 is not a whole number or is outside %2…%3")
                             : QStringLiteral("%1 is outside %2…%3"))
            .arg(toQString(text), toQString(numberText(option.min)), toQString(numberText(option.max)));
    }
    return {};
}

QString takeTimes(const Parts& parts, Injection& injection)
{
    if (parts.start) {
        const std::optional<double> start = readTime(*parts.start);
        if (!start) {
            return QStringLiteral("the start \"%1\" is not a time").arg(toQString(*parts.start));
        }
        injection.at = Seconds(*start);
    }
    if (parts.duration) {
        const std::optional<double> duration = readTime(*parts.duration);
        if (!duration || *duration == 0.0) {
            return QStringLiteral("the duration \"%1\" is not a time above 0").arg(toQString(*parts.duration));
        }
        injection.duration = Seconds(*duration);
    }
    return {};
}

// The unit as it is written after a number.
std::string unitText(const InjectionOption& option)
{
    if (option.unit.empty()) {
        return "";
    }
    return option.unit == "deg" ? "°" : ' ' + std::string(option.unit);
}

std::string whom(const InjectionOption& option, const Injection& injection)
{
    if (!option.takesAxis || option.kind == FaultKind::PowerLoss) {
        return "";
    }
    if (!injection.axis) {
        return "both axes: ";
    }
    return injection.axis == Axis::Azimuth ? "azimuth: " : "elevation: ";
}

const InjectionOption& optionOf(FaultKind kind)
{
    return *std::ranges::find(kOptions, kind, &InjectionOption::kind);
}

}  // namespace

bool isOfAdapter(FaultKind kind)
{
    return optionOf(kind).ofAdapter;
}

const InjectionOption* findInjectionOption(std::string_view name)
{
    const auto* const found = std::ranges::find(kOptions, name, &InjectionOption::name);
    return found != kOptions.end() ? found : nullptr;
}

Result<Injection> parseInjection(const InjectionOption& option, std::string_view text)
{
    const Parts parts = split(text);
    Injection injection{.kind = option.kind};
    QString problem = takeAxis(option, parts, injection);
    if (problem.isEmpty()) {
        problem = takeValue(option, parts, injection);
    }
    if (problem.isEmpty()) {
        problem = takeTimes(parts, injection);
    }
    if (!problem.isEmpty()) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("--%1 %2: %3. Expected %4")
                           .arg(toQString(option.name), toQString(text), problem, toQString(arguments(option))));
    }
    if (option.kind == FaultKind::DuplicateId && !injection.axis) {
        injection.axis = Axis::Elevation;  // if both axes took the id of the other, the ids would differ again
    }
    return injection;
}

Result<Injection> parseInjection(std::string_view text)
{
    const std::string_view name = text.substr(0, text.find(' '));
    const InjectionOption* const option = findInjectionOption(name);
    if (option == nullptr) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("The simulated mount has no fault \"%1\". \"boresightctl help simulate\" lists "
                                      "the faults.")
                           .arg(toQString(name)));
    }
    return parseInjection(*option, text.substr(std::min(name.size() + 1, text.size())));
}

std::string describe(const Injection& injection)
{
    const InjectionOption& option = optionOf(injection.kind);
    std::string text(option.text);
    if (option.need == kOptional && !injection.value) {
        text.erase(text.find('.'));
    } else if (const std::size_t place = text.find('#'); place != std::string::npos) {
        text.replace(place, 1, numberText(injection.value.value_or(0.0)) + unitText(option));
    }
    if (option.kind == FaultKind::DriveFault) {
        text.erase(text.find('.'));
        text += ", " + std::string(moteus::faultText(static_cast<int>(injection.value.value_or(0.0))).name);
    }
    return whom(option, injection) + text;
}

std::string injectionHelp()
{
    std::string help;
    for (const InjectionOption& option : kOptions) {
        std::string text(option.text);
        if (const std::size_t place = text.find('#'); place != std::string::npos) {
            text.replace(place, 1, std::string(option.value) + unitText(option));
        }
        help += "  --" + std::string(option.name) + ' ' + arguments(option) + "\n        " + text + '\n';
    }
    return help;
}

}  // namespace boresight::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/sentence.h"

#include "core/base/control_characters.h"
#include "core/base/hex.h"
#include "core/base/numbers.h"
#include "core/orientation/fields.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace boresight::orientation {
namespace {

constexpr std::array<std::string_view, 2> kHeads{"$PATRK,", "$PANT,TRK,"};

// Indices of the fields after the head.
constexpr std::size_t kTime = 0;
constexpr std::size_t kAzimuth = 2;
constexpr std::size_t kElevation = 4;
constexpr std::size_t kRevolutions = 6;
constexpr std::size_t kTemperature = 8;  // only if its unit follows; otherwise the calibration begins here
constexpr std::size_t kCalibrationDigits = 4;

std::string_view headOf(std::string_view sentence)
{
    for (const std::string_view head : kHeads) {
        if (sentence.starts_with(head)) {
            return head;
        }
    }
    return {};
}

std::vector<std::string_view> fieldsOf(std::string_view text)
{
    std::vector<std::string_view> fields;
    for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
        fields.push_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    fields.push_back(text);
    return fields;
}

bool hasTemperature(const std::vector<std::string_view>& fields)
{
    return fields.size() > kTemperature + 1 && fields[kTemperature + 1] == "c";
}

std::size_t calibrationPlace(const std::vector<std::string_view>& fields)
{
    return hasTemperature(fields) ? kTemperature + 2 : kTemperature;
}

bool isComplete(const std::vector<std::string_view>& fields)
{
    return fields.size() >= calibrationPlace(fields) + kCalibrationDigits;
}

char checksumOf(std::string_view body)
{
    char sum = 0;
    for (const char character : body) {
        sum = static_cast<char>(sum ^ character);
    }
    return sum;
}

// `digits` is the text after the '*' at the end of `body`.
std::optional<Refusal> checksumProblem(std::string_view body, std::string_view digits)
{
    const auto sum = parseHex(digits);
    if (!sum || sum->size() != 1) {
        return Refusal::BadChecksum;
    }
    return static_cast<char>(sum->front()) == checksumOf(body) ? std::nullopt : std::optional(Refusal::WrongChecksum);
}

// A number as printf writes it: digits with at most a minus sign and a point, or "nan" and "inf".
Parsed<double> decimalOf(std::string_view text, const char* field)
{
    const std::string_view unsignedText = text.starts_with('-') ? text.substr(1) : text;
    if (unsignedText.starts_with("nan") || unsignedText.starts_with("inf")) {
        return refused(Refusal::NotFinite, field);
    }
    const bool plain = text.find_first_not_of("-.0123456789") == std::string_view::npos;
    const auto value = plain ? parseFinite(text) : std::nullopt;
    return value ? Parsed<double>(*value) : refused(Refusal::NotANumber, field);
}

Parsed<std::int64_t> wholeOf(std::string_view text, const char* field)
{
    const bool plain = text.find_first_not_of("-0123456789") == std::string_view::npos;
    const auto value = plain ? parseInteger(text) : std::nullopt;
    return value ? Parsed<std::int64_t>(*value) : refused(Refusal::NotANumber, field);
}

bool hasItsUnits(const std::vector<std::string_view>& fields)
{
    return fields[kTime + 1] == "ms" && fields[kAzimuth + 1] == "dd" && fields[kElevation + 1] == "dd" &&
           fields[kRevolutions + 1] == "revs";
}

Parsed<Calibration> calibrationOf(const std::vector<std::string_view>& fields)
{
    std::array<int, kCalibrationDigits> digits{};
    for (std::size_t place = 0; place < digits.size(); ++place) {
        const auto digit =
            wholeOf(fields[calibrationPlace(fields) + place], "calibration").and_then(&calibrationDigitOf);
        if (!digit) {
            return tl::unexpected(digit.error());
        }
        digits[place] = *digit;
    }
    return Calibration{.system = digits[0], .gyro = digits[1], .accelerometer = digits[2], .magnetometer = digits[3]};
}

std::string unknownOf(const std::vector<std::string_view>& fields)
{
    std::string unknown;
    for (std::size_t place = calibrationPlace(fields) + kCalibrationDigits; place < fields.size(); ++place) {
        unknown += (unknown.empty() ? "" : ",") + printable(std::string(fields[place]));
    }
    return unknown;
}

// Stores a value. False: stores the reason of the refusal instead.
template <class Field, class Value>
bool taken(Field& field, const Parsed<Value>& value, std::optional<Refused>& why)
{
    if (!value) {
        why = value.error();
        return false;
    }
    field = *value;
    return true;
}

Parsed<Orientation> valuesOf(const std::vector<std::string_view>& fields)
{
    Orientation value;
    std::optional<Refused> why;
    const auto toDouble = [](std::int64_t whole) { return static_cast<double>(whole); };
    const bool read =
        taken(value.sensorTime, wholeOf(fields[kTime], "time").and_then(&timeOf), why) &&
        taken(value.extendedAzimuth, decimalOf(fields[kAzimuth], "azimuth").and_then(&azimuthOf), why) &&
        taken(value.elevation, decimalOf(fields[kElevation], "elevation").and_then(&elevationOf), why) &&
        taken(value.revolutions, wholeOf(fields[kRevolutions], "revolutions"), why) &&
        (!hasTemperature(fields) ||
         taken(value.temperature, wholeOf(fields[kTemperature], "temperature").map(toDouble).and_then(&temperatureOf),
               why)) &&
        taken(value.calibration, calibrationOf(fields), why);
    if (!read) {
        return tl::unexpected(*why);
    }
    value.heading = SensorHeading::folded(value.extendedAzimuth);
    value.unknown = unknownOf(fields);
    return value;
}

}  // namespace

bool isOurs(std::string_view sentence)
{
    return !headOf(sentence).empty();
}

Parsed<Orientation> parseSentence(std::string_view sentence, SteadyTime arrival)
{
    if (!isOurs(sentence)) {
        return refused(Refusal::FieldCount);
    }
    const std::size_t star = sentence.find('*');
    const std::string_view body = sentence.substr(0, star);
    const std::vector<std::string_view> fields = fieldsOf(body.substr(headOf(sentence).size()));
    if (star == std::string_view::npos) {
        return refused(isComplete(fields) ? Refusal::NoChecksum : Refusal::Truncated);
    }
    if (const auto problem = checksumProblem(body.substr(1), sentence.substr(star + 1))) {
        return refused(*problem);
    }
    if (!isComplete(fields)) {
        return refused(Refusal::FieldCount);
    }
    if (!hasItsUnits(fields)) {
        return refused(Refusal::Unit);
    }
    auto value = valuesOf(fields);
    if (value) {
        value->arrival = arrival;
        value->transport = Transport::Serial;
    }
    return value;
}

bool hasLowerCaseChecksum(std::string_view sentence)
{
    const std::size_t star = sentence.find('*');
    return star != std::string_view::npos && sentence.substr(star).find_first_of("abcdef") != std::string_view::npos;
}

std::string withChecksum(std::string_view body)
{
    const std::array<std::uint8_t, 1> sum{static_cast<std::uint8_t>(checksumOf(body))};
    return '$' + std::string(body) + '*' + toHex(sum, HexCase::Upper);
}

}  // namespace boresight::orientation

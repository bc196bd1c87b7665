// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

// A record type lists its fields once, in a function template `xFields(visitor, value)` that names the key, the unit
// and the range of each. A visitor reads or writes a file: TomlReader, TomlWriter, JsonReader, JsonWriter. The
// functions here give the plain numbers in a file their units. A writer gets a copy of the record, because rounding may
// change it. Pure.
namespace boresight::records {

// Both ends are included.
struct Range
{
    double min;
    double max;
};

template <class Visitor>
void inDegrees(Visitor& visitor, std::string_view key, Angle& value, Range range)
{
    double degrees = value.degrees();
    visitor.number(key, degrees, range);
    value = Angle::fromDegrees(degrees);
}

// For an angle or a rate.
template <class Visitor, int PerSecond>
void inRadians(Visitor& visitor, std::string_view key, Quantity<AngleKind, PerSecond>& value, Range range)
{
    double radians = value.radians();
    visitor.number(key, radians, range);
    value = Quantity<AngleKind, PerSecond>::fromRadians(radians);
}

template <class Visitor>
void inTurns(Visitor& visitor, std::string_view key, MotorTurns& value, Range range)
{
    double turns = value.turns();
    visitor.number(key, turns, range);
    value = MotorTurns::fromTurns(turns);
}

template <class Visitor>
void inSeconds(Visitor& visitor, std::string_view key, Seconds& value, Range range)
{
    double seconds = value.count();
    visitor.number(key, seconds, range);
    value = Seconds(seconds);
}

template <class Visitor>
void inMilliseconds(Visitor& visitor, std::string_view key, std::chrono::milliseconds& value, Range range)
{
    std::int64_t count = value.count();
    visitor.whole(key, count, range);
    value = std::chrono::milliseconds(count);
}

// For an integer, or for an enumeration by the number of its value.
template <class Visitor, class Value>
void asWhole(Visitor& visitor, std::string_view key, Value& value, Range range)
{
    auto whole = static_cast<std::int64_t>(value);
    visitor.whole(key, whole, range);
    value = static_cast<Value>(whole);
}

// True: the record has the value, so its fields follow. A reader creates the value if the file has one of the keys.
template <class Visitor, class Value>
bool isThere(Visitor& visitor, std::initializer_list<std::string_view> keys, std::optional<Value>& value)
{
    bool there = false;
    for (const std::string_view key : keys) {
        there = there || visitor.has(key, value.has_value());
    }
    if (there && !value) {
        value.emplace();
    }
    return there;
}

template <class Visitor>
void optionalInDegrees(Visitor& visitor, std::string_view key, std::optional<Angle>& value, Range range)
{
    if (isThere(visitor, {key}, value)) {
        inDegrees(visitor, key, *value, range);
    }
}

template <class Visitor, class Value, class Fields>
void optionalTable(Visitor& visitor, std::string_view key, std::optional<Value>& value, Fields fields)
{
    if (isThere(visitor, {key}, value)) {
        visitor.table(key, *value, fields);
    }
}

}  // namespace boresight::records

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/calibration/record_fields.h"
#include "core/calibration/record_text.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace boresight::calibration {
namespace {

using namespace boresight::calibration::record;

constexpr int kDecimals = 9;  // a millionth of an arc second; they hide the rounding between degrees and radians

std::string inQuotes(const std::string& text)
{
    std::string result = "\"";
    for (const char character : printable(text)) {
        if (character == '"' || character == '\\') {
            result += '\\';
        }
        result += character;
    }
    return result + "\"";
}

std::string decimal(double value)
{
    std::string text = formatFixed(value, kDecimals);
    if (const std::size_t dot = text.find('.'); dot != std::string::npos) {
        text.erase(std::max(text.find_last_not_of('0'), dot + 1) + 1);
    }
    return text;
}

std::string twoDigits(int value)
{
    return (value < 10 ? "0" : "") + std::to_string(value);
}

std::string isoTime(UtcTime time)
{
    const auto moment = std::chrono::floor<std::chrono::milliseconds>(time);
    const auto day = std::chrono::floor<std::chrono::days>(moment);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss clock(moment - day);
    std::string millis = std::to_string(clock.subseconds().count());
    millis.insert(0, 3 - millis.size(), '0');
    return std::to_string(static_cast<int>(date.year())) + "-" +
           twoDigits(static_cast<int>(static_cast<unsigned>(date.month()))) + "-" +
           twoDigits(static_cast<int>(static_cast<unsigned>(date.day()))) + "T" +
           twoDigits(static_cast<int>(clock.hours().count())) + ":" +
           twoDigits(static_cast<int>(clock.minutes().count())) + ":" +
           twoDigits(static_cast<int>(clock.seconds().count())) + "." + millis + "Z";
}

class Writer
{
public:
    void angle(std::string_view key, Angle value, Range) { line(key, decimal(value.degrees())); }
    void number(std::string_view key, double value, Range) { line(key, decimal(value)); }
    void text(std::string_view key, const std::string& value) { line(key, inQuotes(value)); }
    void flag(std::string_view key, bool value) { line(key, value ? "true" : "false"); }
    void time(std::string_view key, UtcTime value) { line(key, isoTime(value)); }

    void optionalAngle(std::string_view key, const std::optional<Angle>& value, Range range)
    {
        if (value) {
            angle(key, *value, range);
        }
    }

    template <class Choice>
    void choice(std::string_view key, Choice value, std::span<const std::string_view> names)
    {
        line(key, inQuotes(std::string(names[static_cast<std::size_t>(value)])));
    }

    template <class Value>
    void table(std::string_view key, Value& value)
    {
        inside(key, "[", "]", value);
    }

    template <class Value>
    void optionalTable(std::string_view key, std::optional<Value>& value)
    {
        if (value) {
            table(key, *value);
        }
    }

    template <class Value>
    void list(std::string_view key, std::vector<Value>& values)
    {
        for (Value& value : values) {
            inside(key, "[[", "]]", value);
        }
    }

    void line(std::string_view key, const std::string& value) { m_text += std::string(key) + " = " + value + "\n"; }

    [[nodiscard]] const std::string& written() const { return m_text; }

private:
    template <class Value>
    void inside(std::string_view key, const char* open, const char* close, Value& value)
    {
        const std::string path = m_path;
        m_path += (path.empty() ? "" : ".") + std::string(key);
        m_text += "\n" + (open + m_path) + close + "\n";
        fields(*this, value);
        m_path = path;
    }

    std::string m_path;
    std::string m_text;
};

}  // namespace

Result<std::string> toText(const CalibrationHistory& history)
{
    Writer writer;
    writer.line("version", std::to_string(kVersion));
    writer.line("in_force", std::to_string(history.inForce()));
    std::vector<CalibrationRecord> entries = history.entries();
    writer.list("calibration", entries);
    std::vector<CalibrationRecord> superseded = history.superseded();
    writer.list("superseded", superseded);
    const std::string text =
        "# Boresight: calibrations of one mount, the oldest first. Angles are in degrees.\n" + writer.written();
    return parseHistory(text, "history").map([&](const CalibrationHistory&) { return text; });
}

}  // namespace boresight::calibration

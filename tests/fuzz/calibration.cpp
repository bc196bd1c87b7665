// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-POWER-02 (Fuzz.calibration)
// REQ-CALIBRATION-19 (Fuzz.calibration)
// REQ-CALIBRATION-20 (Fuzz.calibration)
// The calibration file of a mount: gives any bytes to parseHistory(). An accepted file can be written, and then reads
// back as the same text. The same for the terms of a pointing model with parseTerms(), and any line for parsePower().
#include "core/base/control_characters.h"
#include "core/calibration/record_text.h"
#include "core/calibration/terms_text.h"
#include "core/power/power_text.h"
#include "tests/fakes/text_of.h"
#include "tests/fuzz/harness.h"

#include <cmath>

namespace boresight::fuzz {
namespace {

using namespace boresight::calibration;

constexpr std::size_t kMaxInput = 6000;  // a full example has some 3000 bytes

void checkReason(std::string text)
{
    require(text.starts_with("a.toml:"), "an error begins with its file");
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
        text.erase(0, end + 1);
        require(text.starts_with("a.toml:"), "so does every further one");
    }
    require(!hasControlCharacters(text), "an error is printable");
}

void checkAccepted(const CalibrationHistory& history)
{
    require(history.inForce() <= history.entries().size(), "no more is in force than there is");
    for (const CalibrationRecord& record : history.entries()) {
        for (const CalibrationPoint& point : record.points) {
            require(point.axes.azimuth.isFinite() && point.sigma > Angle{}, "a point is finite, and has a sigma");
        }
        require(!hasControlCharacters(record.title.toStdString()), "a title is printable");
    }
    const auto written = toText(history);
    require(written.has_value(), "an accepted history can be written");
    const auto again = parseHistory(*written, QStringLiteral("a.toml"));
    require(again.has_value() && toText(*again) == written, "a written history reads back as the same text");
}

void checkTerms(std::string_view text)
{
    const auto sheet = parseTerms(text, QStringLiteral("a.toml"));
    if (!sheet) {
        checkReason(textOf(sheet.error()));
        return;
    }
    accept();
    const std::string written = toText(*sheet);
    const auto again = parseTerms(written, QStringLiteral("a.toml"));
    require(again.has_value() && toText(*again) == written, "written terms read back as the same text");
}

CalibrationRecord example()
{
    CalibrationRecord record;
    record.when = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} + std::chrono::milliseconds(51825123);
    record.title = QStringLiteral("Two points of the Sun");
    record.mount = {.azimuthDrive = "4f2c1a90-11d2-4c6b-9f00-0123456789ab",
                    .elevationDrive = "",
                    .site = RecordSite{38.7_deg, -9.1_deg, 120.0}};
    record.terms.after.azimuthOffset = 37.4_deg;
    record.sigmas[0] = 0.05_deg;
    DeviationCurve curve;
    curve.a1 = 8_deg;
    curve.unreliable = {{.from = 350_deg, .to = 10_deg, .residual = -15_deg}};
    record.sensor = Change<SensorMounting>{
        .before = {}, .after = {.sense = {}, .azimuthOffset = 3_deg, .elevationOffset = {}, .curve = curve}};
    record.points = {
        {.axes = {370_deg, 30_deg}, .truth = {47.4_deg, 30_deg}, .when = record.when, .label = QStringLiteral("Sun")},
        {.axes = {10_deg, 60_deg}, .truth = {47.4_deg, 60_deg}, .when = record.when, .label = QStringLiteral("Moon")}};
    return record;
}

std::string textOf(const CalibrationHistory& history)
{
    const auto text = toText(history);
    require(text.has_value(), "the examples can be written");
    return *text;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    CalibrationRecord bare;
    bare.when = example().when;
    grammar.corpus = {textOf({}), textOf({{bare}, 0}), textOf({{example(), bare}, 1}), "RSSI: -73.2 dBm",
                      toText(TermSheet{.mountName = "Roof",
                                       .when = example().when,
                                       .mount = example().mount,
                                       .terms = example().terms.after,
                                       .sigmas = example().sigmas})};
    grammar.tokens = {"[[calibration]]\n",
                      "[[calibration.point]]\n",
                      "[calibration.sensor.after.curve]\n",
                      "[[calibration.sensor.after.curve.unreliable]]\n",
                      "[calibration.site]\n",
                      "tilt_north -0.5 arcmin 2\n",
                      "# site: 90 -180 0\n",
                      "# date: 2200-12-31T23:59:59Z\n",
                      "in_force = 1\n",
                      "in_force = 0.5\n",
                      "version = 2\n",
                      "sense = \"counterclockwise\"\n",
                      "used = false\n",
                      "sigma_deg = 0\n",
                      "when = 2026-02-29T00:00:00Z\n",
                      "2200-12-31T23:59:59.9999Z",
                      "1970-01-01T00:00:00+14:00",
                      "2026-11-21",
                      "nan",
                      "-inf",
                      "1e400",
                      "360",
                      "0x10",
                      "-0.0",
                      "0.0000000004",
                      "{}",
                      "[]",
                      "[{}]",
                      "\"\"",
                      "\\u0000",
                      "\\n",
                      "'",
                      "\"\"\"",
                      "\xc3\xa9",
                      "\xff",
                      "#",
                      "\r\n"};
    grammar.separators = " \n=[]\".";
    grammar.maxLength = kMaxInput;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const auto power = power::parsePower(asText(input));
    require(!power || std::abs(*power) <= power::kLargestPower, "a power is one in dB");
    checkTerms(asText(input));
    const auto history = parseHistory(asText(input), QStringLiteral("a.toml"));
    if (!history) {
        checkReason(textOf(history.error()));
        return;
    }
    accept();
    checkAccepted(*history);
}

}  // namespace boresight::fuzz

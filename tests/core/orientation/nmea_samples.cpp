// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/orientation/nmea_samples.h"

#include "core/base/hex.h"
#include "core/base/numbers.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace boresight::orientation {
namespace {

std::string unescaped(const std::string& text)
{
    std::string bytes;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\\' || at + 1 == text.size()) {
            bytes += text[at];
            continue;
        }
        const char kind = text[++at];
        if (kind == 'x') {
            bytes += static_cast<char>(parseHex(text.substr(at + 1, 2)).value().at(0));
            at += 2;
        } else {
            bytes += kind == 'r' ? '\r' : kind == 'n' ? '\n' : kind;
        }
    }
    return bytes;
}

NmeaSample sampleOf(const std::string& line, const std::string& where)
{
    std::istringstream stream(line);
    std::string verdict;
    std::string bytes;
    NmeaSample sample{.where = where};
    std::getline(stream, verdict, '\t');
    std::getline(stream, sample.result, '\t');
    std::getline(stream, bytes, '\t');
    sample.bytes = unescaped(bytes);
    if (verdict.starts_with("OK")) {
        sample.verdict = SampleVerdict::Accepted;
        const auto count = verdict.find('x');
        sample.accepted = count == std::string::npos ? 1 : std::stoul(verdict.substr(count + 1));
    } else {
        EXPECT_TRUE(verdict == "BAD" || verdict == "IGNORE") << where << ": " << verdict;
        sample.verdict = verdict == "BAD" ? SampleVerdict::Refused : SampleVerdict::Ignored;
    }
    return sample;
}

bool isNear(const std::string& expected, Angle angle)
{
    return abs(Angle::fromDegrees(parseFinite(expected).value()) - angle) < Angle::fromDegrees(0.001);
}

std::string digitsOf(const Calibration& calibration)
{
    std::ostringstream digits;
    digits << calibration.system << '/' << calibration.gyro << '/' << calibration.accelerometer << '/'
           << calibration.magnetometer;
    return digits.str();
}

bool agrees(const std::string& key, const std::string& expected, const Orientation& value)
{
    if (key == "ts") {
        return parseInteger(expected) ==
               std::chrono::duration_cast<std::chrono::milliseconds>(value.sensorTime.time_since_epoch()).count();
    }
    if (key == "az") {
        return isNear(expected, value.extendedAzimuth);
    }
    if (key == "heading") {
        return isNear(expected, value.heading.angle());
    }
    if (key == "el") {
        return isNear(expected, value.elevation);
    }
    if (key == "revs") {
        return parseInteger(expected) == value.revolutions;
    }
    if (key == "temp") {
        return expected == "-" ? !value.temperature : value.temperature == parseFinite(expected);
    }
    return key == "cal" && value.calibration && expected == digitsOf(*value.calibration);
}

}  // namespace

std::vector<NmeaSample> samplesOf(const std::string& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file.is_open()) << path;
    std::vector<NmeaSample> samples;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (!line.empty() && line.front() != '#') {
            samples.push_back(sampleOf(line, path + ":" + std::to_string(number)));
        }
    }
    EXPECT_FALSE(samples.empty()) << path;
    return samples;
}

std::vector<NmeaSample> ownSamples()
{
    return samplesOf(BORESIGHT_TEST_DATA "/nmea_samples.txt");
}

std::vector<NmeaSample> allSamples()
{
    std::vector<NmeaSample> samples = ownSamples();
    if (const char* const other = std::getenv("NMEA_SAMPLES")) {
        const std::vector<NmeaSample> more = samplesOf(other);
        samples.insert(samples.end(), more.begin(), more.end());
    }
    return samples;
}

std::vector<std::string> valueGroups(const std::string& result)
{
    std::vector<std::string> groups;
    for (auto at = result.find("ts="); at != std::string::npos;) {
        const auto next = result.find("ts=", at + 1);
        groups.push_back(result.substr(at, next - at));
        at = next;
    }
    return groups;
}

std::string differences(const std::string& group, const Orientation& value)
{
    std::istringstream words(group);
    std::string found;
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        if (equals != std::string::npos && !agrees(word.substr(0, equals), word.substr(equals + 1), value)) {
            found += word + " ";
        }
    }
    return found;
}

}  // namespace boresight::orientation

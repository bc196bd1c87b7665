// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"

#include <string>
#include <string_view>
#include <vector>

// The recorded sentences of tests/data/nmea_samples.txt, and of another file in the same form if the environment
// variable NMEA_SAMPLES names one. Each line has verdict, result, bytes and note, separated by tabs.
namespace boresight::orientation {

enum class SampleVerdict
{
    Accepted,  // `accepted` has the number of sentences
    Refused,
    Ignored
};

struct NmeaSample
{
    std::string where;  // file and line
    SampleVerdict verdict = SampleVerdict::Ignored;
    std::size_t accepted = 0;
    std::string result;  // the decoded values, or the reason
    std::string bytes;
};

[[nodiscard]] std::vector<NmeaSample> samplesOf(const std::string& path);
[[nodiscard]] std::vector<NmeaSample> ownSamples();
[[nodiscard]] std::vector<NmeaSample> allSamples();

// The values that `result` lists, one group for each sentence: "ts=… az=… heading=…".
[[nodiscard]] std::vector<std::string> valueGroups(const std::string& result);
// Differences between the group and the value, in words; empty if there are none.
[[nodiscard]] std::string differences(const std::string& group, const Orientation& value);

}  // namespace boresight::orientation

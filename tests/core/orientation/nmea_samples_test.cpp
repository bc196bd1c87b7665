// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/orientation/nmea_samples.h"

#include "core/orientation/sentence_stream.h"

#include <gtest/gtest.h>

namespace boresight::orientation {
namespace {

struct Heard
{
    std::vector<Orientation> values;
    std::vector<std::string> reasons;
    Counts counts;

    bool operator==(const Heard&) const = default;
};

Heard heard(const std::vector<std::string_view>& reads)
{
    Heard heard;
    SentenceStream stream;
    for (const std::string_view read : reads) {
        stream.add(
            read, SteadyTime{}, [&](const Orientation& value) { heard.values.push_back(value); },
            [&](const Refused& refused, std::string_view) { heard.reasons.push_back(toText(refused)); });
    }
    heard.counts = stream.counts();
    return heard;
}

void expectAsTold(const NmeaSample& sample, const Heard& heard)
{
    EXPECT_EQ(heard.values.size(), sample.accepted) << sample.where;
    EXPECT_EQ(heard.counts.accepted, sample.accepted) << sample.where;
    EXPECT_EQ(heard.counts.allRefused(), heard.reasons.size()) << sample.where;
    if (sample.verdict == SampleVerdict::Refused) {
        EXPECT_GT(heard.reasons.size(), 0U) << sample.where;
    } else if (sample.verdict == SampleVerdict::Ignored) {
        EXPECT_EQ(heard.reasons.size(), 0U) << sample.where;
    }
    const auto groups = valueGroups(sample.result);
    for (std::size_t place = 0; groups.size() == heard.values.size() && place < groups.size(); ++place) {
        EXPECT_EQ(differences(groups[place], heard.values[place]), "") << sample.where;
    }
}

// REQ-ORIENTATION-01 (NmeaSamples.*): All three forms of the sentence are read. Additional fields at the end are kept
// as text, and the other fields are used.
TEST(NmeaSamples, EachIsAcceptedRefusedOrIgnoredAsTold)
{
    for (const NmeaSample& sample : allSamples()) {
        expectAsTold(sample, heard({sample.bytes, "\r\n"}));
    }
}

TEST(NmeaSamples, OursAreComplete)
{
    std::size_t accepted = 0;
    std::size_t refused = 0;
    std::size_t compared = 0;
    for (const NmeaSample& sample : ownSamples()) {
        accepted += sample.accepted;
        refused += sample.verdict == SampleVerdict::Refused ? 1 : 0;
        compared += valueGroups(sample.result).size();
    }
    EXPECT_EQ(accepted, 11U);
    EXPECT_EQ(compared, accepted);
    EXPECT_EQ(refused, 9U);
}

// REQ-ORIENTATION-02: A sentence is refused with its reason if its checksum is wrong, missing or unreadable, a unit is
// wrong, fields are missing, or a number is not finite or outside the range of a sensor. Refusals are counted by
// reason, and no part of the sentence is used.
TEST(NmeaSamples, TheReasonsAreThoseOfTheFile)
{
    for (const NmeaSample& sample : ownSamples()) {
        if (sample.verdict == SampleVerdict::Refused) {
            EXPECT_EQ(heard({sample.bytes}).reasons, std::vector<std::string>{sample.result}) << sample.where;
        }
    }
}

// REQ-ORIENTATION-03: Bytes may be split or joined anywhere. A `$` begins a new sentence. Noise, start-up text and
// foreign sentences are counted, not reported. A sentence has at most 128 bytes.
TEST(NmeaSamples, AnySplitGivesTheSame)
{
    for (const NmeaSample& sample : allSamples()) {
        const Heard whole = heard({sample.bytes, "\r\n"});
        const std::string_view bytes = sample.bytes;
        for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
            EXPECT_EQ(heard({bytes.substr(0, cut), bytes.substr(cut), "\r\n"}), whole)
                << sample.where << " cut at " << cut;
        }
    }
}

// REQ-ORIENTATION-03
TEST(NmeaSamples, JoinedToOneReadTheyGiveTheSame)
{
    std::string all;
    std::size_t expected = 0;
    for (const NmeaSample& sample : allSamples()) {
        all += sample.bytes + "\r\n";
        expected += sample.accepted;
    }
    const Heard atOnce = heard({all});
    EXPECT_EQ(atOnce.values.size(), expected);
    std::vector<std::string_view> singly;
    for (std::size_t at = 0; at < all.size(); ++at) {
        singly.push_back(std::string_view(all).substr(at, 1));
    }
    EXPECT_EQ(heard(singly), atOnce);
}

}  // namespace
}  // namespace boresight::orientation

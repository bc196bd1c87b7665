// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/soak.h"

#include "core/base/numbers.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

// The length of the soak: BORESIGHT_SOAK_HOURS of mount time, or by default what fits into a run of all tests. SOAK.md
// has the figures of a whole day.
namespace boresight::system_test {
namespace {

constexpr double kUsualHours = 0.75;

// The event log fills up to its 2000 entries, which takes some hours.
constexpr std::size_t kMemoryBound = 256 * 1024;

double hours()
{
    const char* const given = std::getenv("BORESIGHT_SOAK_HOURS");
    return given != nullptr ? parseFinite(given).value_or(kUsualHours) : kUsualHours;
}

void print(const char* what, std::uint64_t count)
{
    std::printf("  %-24s %10llu\n", what, static_cast<unsigned long long>(count));
}

void print(const SoakCounts& counts, const sim::ReplyCounts& said)
{
    print("ticks", counts.ticks);
    print("frames sent", counts.frames);
    print("requests to drives", counts.questions);
    print("not received by a drive", counts.unheard);
    print("replies sent", said.said);
    print("replies lost", said.lost);
    print("replies received", counts.received);
    print("passes", counts.passes);
    print("targets accepted", counts.points);
    print("targets refused", counts.refusedPoints);
    print("short outages, stalls", counts.shortTroubles);
    print("long outages, stalls", counts.longTroubles);
    print("steps of the UTC", counts.clockSteps);
    print("losses", counts.losses);
    print("re-arms", counts.rearms);
    print("recoveries", counts.recoveries);
    print("positions entered", counts.turnsTold);
}

void expectCountsAgree(const SoakCounts& counts, const sim::ReplyCounts& said)
{
    EXPECT_EQ(counts.questions, said.said + counts.unheard) << "each request that a drive received has one reply";
    EXPECT_EQ(said.said, counts.received + said.lost) << "each reply arrives once or is lost";
    EXPECT_EQ(counts.losses, counts.longTroubles)
        << "Boresight notices no short outage. Each long outage stops the mount once";
    EXPECT_EQ(counts.rearms, counts.losses);
    EXPECT_EQ(counts.recoveries, counts.losses);
}

void expectNothingBad(const SoakFindings& findings)
{
    EXPECT_LT(findings.outside, 0.2_deg);
    EXPECT_LT(findings.fastest, 1.1);
    EXPECT_LT(findings.astray, 0.3_deg);
    EXPECT_LT(findings.movedUnarmed, 0.2_deg);
    if (findings.memory.size() > 1) {
        EXPECT_LT(findings.memory.back(), findings.memory.front() + kMemoryBound);
    }
}

TEST(Soak, EndsAsItBegan)
{
    Soak soak(20261121);
    soak.run(Seconds(hours() * 3600.0));
    soak.comeToRest();
    const SoakCounts counts = soak.counts();
    const sim::ReplyCounts said = soak.saidByDrives();
    print(counts, said);
    expectCountsAgree(counts, said);
    expectNothingBad(soak.findings());
    std::printf(
        "  outside %.3f deg, reported position wrong by %.3f deg, fastest %.3f of the limit, moved unarmed %.3f deg. "
        "Bytes in "
        "use by the hour:",
        soak.findings().outside.degrees(), soak.findings().astray.degrees(), soak.findings().fastest,
        soak.findings().movedUnarmed.degrees());
    for (const std::size_t bytes : soak.findings().memory) {
        std::printf(" %zu", bytes);
    }
    std::printf("\n");

    soak.restart();
    const AxisPosition truth = soak.truth();
    for (const Axis axis : kAxes) {
        const Angle real = axis == Axis::Azimuth ? truth.azimuth : truth.elevation;
        const auto& record = soak.journal().journal.turns[index(axis)];
        ASSERT_TRUE(record.has_value()) << soak.journal().problem.toStdString();
        EXPECT_NEAR(record->angle.degrees(), real.degrees(), 0.2) << "the journal has the position with its cable wrap";
        EXPECT_FALSE(record->moving);
    }
    EXPECT_TRUE(soak.status().azimuth.turnKnown) << "the drives kept their power";
    EXPECT_TRUE(soak.status().elevation.turnKnown);
    EXPECT_NEAR(soak.status().azimuth.actual->degrees(), truth.azimuth.degrees(), 0.2);

    soak.powerCycle();
    const auto question = soak.status().drives->azimuth.turnQuestion;
    ASSERT_TRUE(question.has_value()) << "after a power cycle only the operator knows the position";
    ASSERT_TRUE(question->proposed.has_value());
    EXPECT_NEAR(question->proposed->degrees(), soak.truth().azimuth.degrees(), 0.5)
        << "the journal has the position to propose";
}

}  // namespace
}  // namespace boresight::system_test

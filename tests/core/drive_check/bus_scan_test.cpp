// SPDX-License-Identifier: GPL-3.0-or-later
// The scan in hand-turned time. tests/app/link_scan_test.cpp has it in real time and with faults.
#include "core/drive_check/bus_scan.h"

#include "core/sim/simulated_pair.h"

#include <gmock/gmock.h>

namespace boresight::drive_check {
namespace {

constexpr std::uint8_t kSource = 0x33;

struct Ended
{
    std::vector<FoundController> found;
    Seconds after;
    std::size_t mostAtOnce = 0;
};

Ended scan(const sim::PairSettings& settings, Seconds tick)
{
    sim::SimulatedPair pair(settings);
    BusScan scan(kSource, {moteus::versionQuery()});
    const SteadyTime start{std::chrono::hours(1)};
    Ended ended;
    Seconds now{0.0};
    scan.begin(start);
    for (; scan.isRunning() && now < Seconds(10.0); now += tick) {
        const auto frames = scan.frames(start + std::chrono::duration_cast<SteadyTime::duration>(now));
        ended.mostAtOnce = std::max(ended.mostAtOnce, frames.size());
        for (const CanFrame& frame : frames) {
            for (const sim::PairReply& reply : pair.exchange(frame, now)) {
                scan.take(*moteus::decodeReply(reply.frame));
            }
        }
    }
    ended.found = scan.controllers();
    ended.after = now;
    return ended;
}

TEST(BusScan, FindsBothWhateverTheTick)
{
    for (const double tick : {0.003, 0.005, 0.02, 0.05}) {
        const Ended ended = scan(sim::commissionedPair(), Seconds(tick));
        ASSERT_EQ(ended.found.size(), 2u) << tick;
        EXPECT_EQ(ended.found[1].id, 2);
        EXPECT_EQ(ended.found[1].known.value(moteus::Register::RegisterMapVersion), 5.0);
        EXPECT_LE(ended.mostAtOnce, 8u) << "leaves the bus to others";
        EXPECT_LT(ended.after, Seconds(tick > 0.02 ? 3.0 : 1.6)) << tick;
    }
}

TEST(BusScan, FindsTheLastId)
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.elevation.config.id = 126;
    const Ended ended = scan(pair, Seconds(0.02));
    ASSERT_EQ(ended.found.size(), 2u);
    EXPECT_EQ(ended.found[1].id, 126);
}

// Their replies to the scan query are identical bits. All other replies destroy each other.
TEST(BusScan, NoticesTwoBoardsWithOneId)
{
    const Ended ended = scan(sim::factoryPair(), Seconds(0.02));
    ASSERT_EQ(ended.found.size(), 1u);
    EXPECT_TRUE(ended.found[0].isUnreadable());
}

TEST(BusScan, OnlyRepliesToItsOwnNumberCount)
{
    BusScan scan(kSource, {});
    scan.begin(SteadyTime(std::chrono::hours(1)));
    scan.take({.source = 5, .destination = moteus::kHostId});
    EXPECT_TRUE(scan.controllers().empty());
    scan.take({.source = 5, .destination = kSource});
    EXPECT_EQ(scan.controllers().size(), 1u);
}

}  // namespace
}  // namespace boresight::drive_check

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/watched_boards.h"

#include "core/sim/simulated_pair.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace std::chrono_literals;

profile::Profile azimuthOnly()
{
    profile::Profile profile;
    profile.elevation.driver = profile::AxisDriver::None;
    return profile;
}

// The board of the elevation axis. The mount does not use it.
struct WatchedBoardsTest : ::testing::Test
{
    WatchedBoardsTest() { name({"2 polarisation"}); }

    void name(const std::vector<std::string>& wanted)
    {
        profile::Profile profile = azimuthOnly();
        profile.watchedBoards = wanted;
        inForce.apply(profile);
    }
    void run(Seconds time)
    {
        constexpr Seconds kTick{0.02};
        for (const Seconds end = elapsed + time; elapsed < end;) {
            for (const CanFrame& frame : boards.frames(clock.now())) {
                sent.push_back(frame);
                for (const sim::PairReply& reply : pair.exchange(frame, elapsed)) {
                    CanFrame back = reply.frame;
                    back.received = clock.now();
                    boards.take(back);
                }
            }
            clock.advance(kTick);
            elapsed += kTick;
            pair.advanceTo(elapsed);
        }
    }
    [[nodiscard]] QStringList standing() const
    {
        QStringList all;
        for (const Alarm& alarm : alarms.list()) {
            if (alarm.active) {
                all << alarm.what;
            }
        }
        return all;
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::InForce inForce{azimuthOnly()};
    sim::SimulatedPair pair{sim::commissionedPair()};
    WatchedBoards boards{inForce, alarms};
    Seconds elapsed{0.0};
    std::vector<CanFrame> sent;
};

// REQ-MOTEUS_MOUNT-930: A board that the profile names for watching is queried five times a second, and shown with its
// name, id and readings. It is never commanded.
TEST_F(WatchedBoardsTest, AreReadAndNeverCommanded)
{
    run(Seconds(1.0));
    const auto all = boards.status();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].id, 2);
    EXPECT_EQ(all[0].name, QStringLiteral("polarisation"));
    EXPECT_NEAR(all[0].readings.busVoltage.value_or(0.0), 24.0, 1.0);
    EXPECT_EQ(all[0].readings.mode, QStringLiteral("stopped (0)"));
    EXPECT_LE(all[0].readings.age.value_or(1h), 220ms);
    ASSERT_EQ(sent.size(), 5u);
    const auto question = moteus::encode({.destination = 2, .command = {}, .query = moteus::rotatorQuery()});
    for (const CanFrame& frame : sent) {
        EXPECT_EQ(frame.id, question->id);
        EXPECT_EQ(frame.data, question->data);
    }
    EXPECT_EQ(pair.truth(Axis::Elevation).mode, moteus::Mode::Stopped);
}

// REQ-MOTEUS_MOUNT-931: A watched board that is in fault, or silent for 2 s, raises a warning with its name. The
// warning ends when the board is healthy again or is removed from the profile.
TEST_F(WatchedBoardsTest, AFaultAndASilenceAreWarnings)
{
    run(Seconds(1.0));
    EXPECT_TRUE(standing().isEmpty());
    pair.setFitted(Axis::Elevation, false);
    run(Seconds(1.7));
    EXPECT_TRUE(standing().isEmpty());
    run(Seconds(0.5));
    EXPECT_EQ(standing(), QStringList{QStringLiteral("The board polarisation (id 2) does not reply.")});
    pair.setFitted(Axis::Elevation, true);
    run(Seconds(0.5));
    EXPECT_TRUE(standing().isEmpty());
    pair.faults().add({.kind = sim::FaultKind::DriveFault, .axis = Axis::Elevation, .at = elapsed, .value = 38.0});
    run(Seconds(0.5));
    ASSERT_EQ(standing().size(), 1);
    EXPECT_TRUE(standing().front().contains(QStringLiteral("polarisation (id 2) reports fault")));
    EXPECT_TRUE(standing().front().contains(QStringLiteral("(38)"))) << standing().front().toStdString();
    name({});
    run(Seconds(0.1));
    EXPECT_TRUE(standing().isEmpty());
    EXPECT_TRUE(boards.status().empty());
}

}  // namespace
}  // namespace boresight

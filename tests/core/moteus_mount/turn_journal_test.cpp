// SPDX-License-Identifier: GPL-3.0-or-later
// When the position journal is written.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

TEST(StationTurns, MotionIsJournalledAsMotionAndRestAsRest)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.mount.takeJournalChange());
    ASSERT_TRUE(rig.point(100.0, 45.0));
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.mount.takeJournalChange());
    EXPECT_TRUE(rig.mount.journal().turns[0]->moving);
    rig.settle();
    rig.run(Seconds(1.0));
    const auto& record = *rig.mount.journal().turns[0];
    EXPECT_FALSE(record.moving);
    EXPECT_NEAR(record.angle.degrees(), 100.0, 0.01);
    EXPECT_EQ(record.drive, rig.factsOf(Axis::Azimuth).uuid);
    (void)rig.mount.takeJournalChange();
    rig.run(Seconds(10.0));
    EXPECT_FALSE(rig.mount.takeJournalChange()) << "a mount that stands writes nothing";
}

// Story: on a small flash a pass wrote the journal once a second, even where the axis had hardly moved.
// REQ-MEMORY-950: For an axis in motion the journal is written by the angle travelled, at most once a second. A
// position may differ from the journal by a certain angle and still be proposed. The journal is always within half of
// this angle, or within a second of motion.
TEST(StationTurns, MotionIsJournalledByTheAngle)
{
    for (const auto& [rate, most] : {std::pair(0.1, 6), std::pair(0.5, 22), std::pair(2.0, 82)}) {
        StationRig rig;
        rig.run(Seconds(0.5));
        int lines = 0;
        for (int tick = 0; tick < 5000; ++tick) {
            if (tick % 5 == 0) {
                ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = AngularRate::fromDegrees(rate)}}));
            }
            rig.tick();
            lines += rig.mount.takeJournalChange() ? 1 : 0;
            const double gap = rig.azimuthDegrees() - rig.mount.journal().turns[0]->angle.degrees();
            ASSERT_LT(std::abs(gap), std::max(2.5, rate) + 0.1) << rate;
        }
        EXPECT_LE(lines, most) << rate;
    }
}

// REQ-MEMORY-951: The angle between two entries is half of the allowed difference: 2.5°. It is less if the possible
// positions are near each other, and 2.5° if no position can be proposed after a motion anyway.
TEST(StationTurns, TheStepOfTheJournalIsHalfOfWhatMayDiffer)
{
    EXPECT_NEAR(journal::journalStep(360_deg).degrees(), 2.5, 1e-9);
    EXPECT_NEAR(journal::journalStep(100_deg).degrees(), 1.25, 1e-9);
    EXPECT_NEAR(journal::journalStep(20_deg).degrees(), 0.25, 1e-9);
    EXPECT_NEAR(journal::journalStep(3.6_deg).degrees(), 2.5, 1e-9);
}

}  // namespace
}  // namespace boresight

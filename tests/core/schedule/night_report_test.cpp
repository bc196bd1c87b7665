// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/night_report.h"

#include <gmock/gmock.h>

namespace boresight::schedule {
namespace {

// REQ-SCHEDULE-903: The report has the seconds that a pass was tracked, those within 1 and 3 dB of the beam, and the
// rms and peak error on the sky.
TEST(NightReport, ATallyHasSecondsAndErrors)
{
    PassTally tally({.number = 25544, .name = QStringLiteral("TEST ONE"), .why = {}});
    tally.add(0_deg, Seconds(10.0), 10_deg);
    tally.add(2.8_deg, Seconds(10.0), 10_deg);
    tally.add(4.9_deg, Seconds(10.0), 10_deg);
    tally.add(6_deg, Seconds(10.0), 10_deg);
    EXPECT_EQ(tally.record().end, PassEnd::Running);
    const PassRecord record = tally.ended(PassEnd::Set, {});
    EXPECT_EQ(record.tracked, Seconds(40.0));
    EXPECT_EQ(record.within1dB, Seconds(20.0));
    EXPECT_EQ(record.within3dB, Seconds(30.0));
    EXPECT_EQ(record.peakError, 6_deg);
    EXPECT_NEAR(record.rmsError.degrees(), 4.11856, 1e-5);  // of 0, 7.84, 24.01 and 36 deg²
    EXPECT_EQ(record.end, PassEnd::Set);
    EXPECT_EQ(record.number, 25544);
}

TEST(NightReport, ABeamLosesThreeDecibelsAtHalfItsWidth)
{
    EXPECT_NEAR(beamLoss(5_deg, 10_deg), 3.0103, 1e-4);
    EXPECT_NEAR(beamLoss(2.882_deg, 10_deg), 1.0, 1e-3);
    EXPECT_EQ(beamLoss(0_deg, 10_deg), 0.0);
}

TEST(NightReport, APassThatSomebodyEndedIsNotDone)
{
    const PassTally tally({.number = 1, .name = {}, .why = {}});
    const NightReport report{.passes = {tally.ended(PassEnd::Set, {}), tally.ended(PassEnd::Manual, {})}};
    EXPECT_EQ(report.done(), 1);
    EXPECT_EQ(report.passes[0].rmsError, 0_deg) << "without a measured beam there is no error";
}

}  // namespace
}  // namespace boresight::schedule

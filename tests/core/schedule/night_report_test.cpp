// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/night_report.h"

#include <gmock/gmock.h>

namespace boresight::schedule {
namespace {

PassTally::Look lookAt(Angle error, Seconds during, bool isOnTarget = true)
{
    return {.error = error, .isOnTarget = isOnTarget, .during = during};
}

// REQ-SCHEDULE-903: The report of a pass has the seconds that were tracked, the seconds within 1 dB and 3 dB of the
// beam, and the rms and peak error on the sky.
TEST(NightReport, ATallyHasSecondsAndErrors)
{
    PassTally tally({.number = 25544, .name = QStringLiteral("TEST ONE"), .why = {}});
    tally.add(lookAt(0_deg, Seconds(1.0)), 10_deg);  // the beam settles on the target
    for (const Angle error : {0_deg, 2.8_deg, 4.9_deg, 6_deg}) {
        tally.add(lookAt(error, Seconds(10.0)), 10_deg);
    }
    EXPECT_EQ(tally.record().end, PassEnd::Running);
    const PassRecord record = tally.ended(PassEnd::Set, {});
    EXPECT_EQ(record.tracked, Seconds(41.0));
    EXPECT_EQ(record.within1dB, Seconds(21.0));
    EXPECT_EQ(record.within3dB, Seconds(31.0));
    EXPECT_EQ(record.peakError, 6_deg);
    EXPECT_NEAR(record.rmsError.value().degrees(), 4.11856, 1e-5);  // rms of the squares 0, 7.84, 24.01 and 36 deg²
    EXPECT_EQ(record.end, PassEnd::Set);
    EXPECT_EQ(record.number, 25544);
}

// Story: tracking began in the middle of a pass. The error was reported as 40°, although the pass was tracked within
// 0.1° from then on.
// REQ-SCHEDULE-922: rms and peak error count from the moment when the beam has been on the target for a second, until
// the end of the pass. The time before it counts as seconds outside 1 and 3 dB. A beam that only crosses the target is
// not on it.
TEST(NightReport, TheWayToAPassIsNoError)
{
    PassTally tally({.number = 25544, .name = {}, .why = {}});
    tally.add(lookAt(90_deg, Seconds(20.0), false), 10_deg);
    tally.add(lookAt(0.5_deg, Seconds(0.5)), 10_deg);
    tally.add(lookAt(8_deg, Seconds(1.0), false), 10_deg);
    EXPECT_EQ(tally.record().rmsError, std::nullopt);
    EXPECT_EQ(tally.record().peakError, std::nullopt);
    tally.add(lookAt(0.9_deg, Seconds(0.6)), 10_deg);
    tally.add(lookAt(0.2_deg, Seconds(0.6)), 10_deg);
    tally.add(lookAt(0.1_deg, Seconds(60.0)), 10_deg);
    EXPECT_EQ(tally.record().peakError, 0.1_deg);
    EXPECT_NEAR(tally.record().rmsError.value().degrees(), 0.1, 1e-9);
    tally.add(lookAt(7_deg, Seconds(10.0), false), 10_deg);
    EXPECT_EQ(tally.record().peakError, 7_deg) << "it was lost on the way";
    EXPECT_EQ(tally.record().tracked, Seconds(92.7));
    EXPECT_EQ(tally.record().within3dB, Seconds(61.7));
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
    EXPECT_EQ(report.passes[0].rmsError, std::nullopt) << "without a measured beam there is no error";
}

}  // namespace
}  // namespace boresight::schedule

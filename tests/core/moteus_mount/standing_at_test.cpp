// SPDX-License-Identifier: GPL-3.0-or-later
// A position of the axes from the command line.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

using moteus::HomeState;

// The time at the beginning of a test.
UtcTime startOfTest()
{
    return fakes::ManualClock().utc();
}

// Story: an adapter was unplugged during a motion. When it came back, the position from the command line at the start
// of the program answered the new question about the wrap. The mount was wrong by many turns of the rotor.
TEST(StationTurns, TheCommandLineAnswersOnlyTheFirstQuestion)
{
    StationRig rig(profile::Profile{}, {.problem = QStringLiteral("The journal file is missing."),
                                        .standingAt = {0_deg, 0_deg},
                                        .looked = startOfTest()});
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
    rig.settle();
    rig.azimuth.silent = true;
    rig.run(Seconds(1.0));
    auto facts = rig.factsOf(Axis::Azimuth);
    facts.bootedAt = rig.clock.now();
    rig.learn(Axis::Azimuth, facts);
    rig.azimuth.home = HomeState::Rotor;
    rig.azimuth.silent = false;
    rig.run(Seconds(1.0));
    const auto question = rig.control.status().drives->azimuth.turnQuestion;
    ASSERT_TRUE(question);
    for (const QString& line : question->evidence) {
        EXPECT_FALSE(line.contains(QStringLiteral("missing"))) << "there is a record by now";
    }
}

// Story: "--standing-at 0,0" was left in the unit file, and after a power cut it was believed again.
// REQ-AXES-15a
TEST(StationTurns, APlaceOfTheCommandLineIsForgottenAfterTenMinutes)
{
    using std::chrono::minutes;
    for (const auto& [age, counts] :
         {std::pair{minutes(9), true}, std::pair{minutes(10), false}, std::pair{minutes(-2), false}}) {
        StationRig rig(profile::Profile{}, {.standingAt = {100_deg, 10_deg}, .looked = startOfTest() - age});
        rig.azimuth.home = rig.elevation.home = HomeState::Rotor;
        rig.run(Seconds(0.5));
        EXPECT_EQ(rig.control.status().azimuth.turnKnown, counts) << age.count();
        const auto alarms = rig.control.status().alarms;
        EXPECT_EQ(
            std::ranges::any_of(alarms,
                                [](const Alarm& alarm) {
                                    return alarm.what.startsWith(QStringLiteral(
                                        "Boresight did not use --standing-at for the azimuth drive: The entered"));
                                }),
            !counts);
    }
}

// REQ-AXES-15a
TEST(StationTurns, APlaceOfTheCommandLineCountsAtOneStartOnly)
{
    const TurnKeeper::Start told{.standingAt = {100_deg, 10_deg}, .looked = startOfTest()};
    StationRig first(profile::Profile{}, told);
    first.azimuth.home = first.elevation.home = HomeState::Rotor;
    first.run(Seconds(0.5));
    ASSERT_TRUE(first.control.status().azimuth.turnKnown);
    ASSERT_TRUE(first.control.status().elevation.turnKnown);
    journal::MountJournal kept;
    kept.placeUsed = first.mount.journal().placeUsed;  // the stored time, as if the journal itself was lost
    for (const Seconds later : {Seconds(0.0), Seconds(60.0)}) {
        TurnKeeper::Start again = told;
        again.journal = kept;
        again.looked += std::chrono::round<std::chrono::milliseconds>(later);
        StationRig rig(profile::Profile{}, again);
        rig.azimuth.home = rig.elevation.home = HomeState::Rotor;
        rig.run(Seconds(0.5));
        EXPECT_EQ(rig.control.status().azimuth.turnKnown, later > Seconds(0.0)) << "with a later time it counts";
    }
}

// The mount has moved since, and only then lost its power.
// REQ-AXES-15a
TEST(StationTurns, APlaceThatWasNotNeededIsUsedUpToo)
{
    StationRig rig(profile::Profile{},
                   {.trustFirstContact = true, .standingAt = {100_deg, 10_deg}, .looked = startOfTest()});
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_NEAR(rig.azimuthDegrees(), 0.0, 0.01) << "the drive knew better";
    EXPECT_EQ(rig.mount.journal().placeUsed, startOfTest());
}

}  // namespace
}  // namespace boresight

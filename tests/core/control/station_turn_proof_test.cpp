// SPDX-License-Identifier: GPL-3.0-or-later
// Tests which evidence proves the wrap of an axis after a restart, a silence or the use of other tools: only a position
// that nobody has set since then.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

// A mount whose journal is dated an hour ahead, so Boresight asks the operator. The axes stand at 0°.
journal::MountJournal journalOfTheFuture(const StationRig& rig)
{
    journal::MountJournal journal;
    for (const Axis axis : kAxes) {
        const bool azimuth = axis == Axis::Azimuth;
        const auto& geometry = azimuth ? rig.profile.azimuth.geometry : rig.profile.elevation.geometry;
        const auto& drive = azimuth ? rig.azimuth : rig.elevation;
        const MotorTurns reported = MotorTurns::fromTurns(drive.position);
        journal.turns[index(axis)] =
            journal::recordOf({.drive = rig.factsOf(axis).uuid,
                               .reported = reported,
                               .homeState = drive.home,
                               .uptime = Seconds(std::chrono::hours(1)),
                               .origin = moteus::CountOrigin{.beginning = 1, .offset = drive.origin()}},
                              geometry.toAxis(reported), geometry, false, rig.clock.utc() + std::chrono::hours(1),
                              journal::hostTime(rig.clock));
    }
    return journal;
}

// The program restarts with the saved data. The drives stay powered, and the clock is right again.
void restartInto(StationRig& next, const StationRig& before)
{
    next.clock.advance(Seconds(before.clock.now() - next.clock.now()) + Seconds(1.0));
    next.azimuth = before.azimuth;
    next.elevation = before.elevation;
    for (const Axis axis : kAxes) {
        next.learn(axis, before.facts[index(axis)]);
    }
}

journal::MountJournal withTheClockRight(journal::MountJournal journal)
{
    for (auto& turn : journal.turns) {
        if (turn) {
            turn->when -= std::chrono::hours(1);
        }
    }
    return journal;
}

// Story: while the question was open, the drive's position had been set to the middle of its travel. The program was
// restarted, the date of the journal was right again, and the setting was taken for a motion: a certain error of 180°.
// REQ-AXES-15 (StationTurns.*): The wrap of an axis is proven or asked for, never guessed. While it is unknown there is
// no pointing and no position for clients, and only the operator jogs, slowly.
TEST(StationTurns, CountingFromTheMiddleIsNeverTakenForAMotion)
{
    const StationRig standing;
    StationRig asked(profile::Profile{}, {.journal = journalOfTheFuture(standing)});
    asked.run(Seconds(0.5));
    ASSERT_TRUE(asked.control.status().drives->azimuth.turnQuestion);
    ASSERT_NEAR(asked.azimuthDegrees(), 180.0, 3.6) << "it counts from the middle";
    StationRig again(profile::Profile{}, {.journal = withTheClockRight(asked.mount.journal())});
    restartInto(again, asked);
    again.run(Seconds(0.5));
    EXPECT_FALSE(again.control.status().azimuth.turnKnown);
    const auto question = again.control.status().drives->azimuth.turnQuestion;
    ASSERT_TRUE(question);
    EXPECT_FALSE(question->proposed) << "it could as well have been moved, and set by another tool";
    EXPECT_TRUE(std::ranges::any_of(question->evidence, [](const QString& line) {
        return line.contains(QStringLiteral("The journal has 0.0°"));
    })) << "which still tells where it was";
}

// The same without a restart: the obstacle to the proof may disappear while the drive is silent.
TEST(StationTurns, CountingFromTheMiddleProvesNothingAfterASilenceEither)
{
    const StationRig standing;
    StationRig rig(profile::Profile{}, {.journal = journalOfTheFuture(standing)});
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.status().drives->azimuth.turnQuestion);
    rig.azimuth.silent = true;
    rig.clock.stepUtc(Seconds(std::chrono::hours(1)) + Seconds(1.0));
    rig.run(Seconds(0.5));
    rig.azimuth.silent = false;
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
}

// The program was killed right after the answer was written into the drive and before the new position was saved.
TEST(StationTurns, AnAnswerHalfWrittenIsNeverTakenForAMotion)
{
    const StationRig standing;
    StationRig told(
        profile::Profile{},
        {.journal = journalOfTheFuture(standing), .standingAt = {100.8_deg, 43.2_deg}, .looked = standing.clock.utc()});
    journal::MountJournal saved;
    for (int i = 0; i < 25 && told.azimuth.position < 0.1; ++i) {
        told.tick();
        saved = told.mount.journal();
    }
    ASSERT_NEAR(told.azimuth.position, 0.28, 1e-6);
    StationRig again(profile::Profile{}, {.journal = withTheClockRight(saved)});
    restartInto(again, told);
    again.run(Seconds(0.5));
    EXPECT_FALSE(again.control.status().azimuth.turnKnown);
}

enum class OtherTool
{
    Looks,
    Moves,         // turns the axis
    Sets,          // sets the position value in the drive
    MovesAndSets,  // both, so the drive reports the same position as before
};

// Story: another tool moved the axis and then set the old position value in the drive. The mount was 216° from its
// reported position, and Boresight called that certain.
TEST(StationTurns, OnlySettingTheDrivesPositionIsAskedAboutAfterOtherTools)
{
    for (const OtherTool tool : {OtherTool::Looks, OtherTool::Moves, OtherTool::Sets, OtherTool::MovesAndSets}) {
        StationRig rig;
        rig.run(Seconds(0.5));
        ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
        rig.settle();
        ASSERT_TRUE(rig.ask(request::ReleaseBus{}));
        rig.run(Seconds(1.0));
        EXPECT_FALSE(rig.control.measured());
        EXPECT_FALSE(rig.point(10.0, 10.0));
        const double before = rig.azimuth.position;
        if (tool == OtherTool::Moves || tool == OtherTool::MovesAndSets) {
            rig.azimuth.position += 0.1;
        }
        if (tool == OtherTool::Sets || tool == OtherTool::MovesAndSets) {
            rig.azimuth.setExact(tool == OtherTool::Sets ? before + 0.1 : before);
        }
        ASSERT_TRUE(rig.ask(request::TakeBus{}));
        for (const Axis axis : kAxes) {
            rig.learn(axis, rig.facts[index(axis)]);
        }
        rig.run(Seconds(1.5));
        const bool set = tool == OtherTool::Sets || tool == OtherTool::MovesAndSets;
        EXPECT_EQ(rig.control.status().azimuth.turnKnown, !set);
        EXPECT_TRUE(rig.control.status().elevation.turnKnown);
        if (!set) {
            EXPECT_NEAR(rig.azimuthDegrees(), tool == OtherTool::Moves ? 136.0 : 100.0, 0.01);
        }
    }
}

// The same while the program is closed.
TEST(StationTurns, APositionSetWhileTheProgramWasClosedIsAskedAbout)
{
    StationRig before;
    before.run(Seconds(0.5));
    ASSERT_TRUE(before.ask(request::PointAxes{{100_deg, 45_deg}}));
    before.settle();
    before.run(Seconds(1.0));
    for (const bool set : {false, true}) {
        StationRig again(profile::Profile{}, {.journal = before.mount.journal()});
        restartInto(again, before);
        const double reported = again.azimuth.position;
        again.azimuth.position += 0.6;  // turned by hand
        if (set) {
            again.azimuth.setExact(reported);
            again.learn(Axis::Azimuth, again.facts[0]);
        }
        again.run(Seconds(0.5));
        EXPECT_EQ(again.control.status().azimuth.turnKnown, !set);
        if (!set) {
            EXPECT_NEAR(again.azimuthDegrees(), 316.0, 0.01) << "a drive with power counts on";
        }
    }
}

// If the value changes by less than the limit for an encoder jump, or while this computer stalls, nothing else shows
// the change.
TEST(StationTurns, APositionSetWhileTheTurnIsKnownIsFoundOutBySeconds)
{
    for (const bool stalled : {false, true}) {
        StationRig rig;
        rig.run(Seconds(0.5));
        ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
        rig.settle();
        if (stalled) {
            rig.clock.advance(Seconds(20.0));
        }
        rig.azimuth.setExact(rig.azimuth.position + (stalled ? 0.6 : 0.001));
        rig.run(Seconds(6.0));
        EXPECT_FALSE(rig.control.status().azimuth.turnKnown) << stalled;
        EXPECT_TRUE(rig.control.status().elevation.turnKnown) << stalled;
        const auto question = rig.control.status().drives->azimuth.turnQuestion;
        ASSERT_TRUE(question);
        EXPECT_FALSE(question->proposed);
    }
}

// Story: part of the console's answer arrived twice. The value in it was taken for a setting by another tool.
TEST(StationTurns, OneFalseReadingOfTheOriginIsNoSetting)
{
    StationRig rig;
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 45_deg}}));
    rig.settle();
    drive_check::DriveFacts read = rig.facts[0];
    read.origin.origin->offset += MotorTurns::fromTurns(0.5);
    read.origin.asked = rig.clock.now();
    rig.mount.learn(Axis::Azimuth, read);
    rig.run(Seconds(6.0));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
}

// Story: the axis already stood where the drive counts from when the operator was asked. Some seconds after the answer
// this position was taken for a setting by another tool.
TEST(StationTurns, AnAnswerThatNeedsNoSettingIsKept)
{
    const StationRig standing;
    StationRig rig(profile::Profile{}, {.journal = journalOfTheFuture(standing)});
    rig.run(Seconds(0.5));
    ASSERT_TRUE(rig.control.status().drives->azimuth.turnQuestion);
    for (const Axis axis : kAxes) {
        const Angle there = axis == Axis::Azimuth ? 180_deg : 45_deg;
        ASSERT_TRUE(rig.ask(request::ChooseTurn{axis, there}));
        rig.run(Seconds(0.2));
    }
    rig.run(Seconds(12.0));
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown);
    EXPECT_TRUE(rig.control.status().elevation.turnKnown);
}

// Until the origin of the drive's count is known, the stored record of the drive must not count as proof.
TEST(StationTurns, ARecordOfADriveThatDoesNotTellProvesNothing)
{
    StationRig before;
    before.run(Seconds(0.5));
    ASSERT_TRUE(before.mount.journal().turns[0]->origin);
    journal::MountJournal old = before.mount.journal();
    old.turns[0]->origin.reset();
    StationRig again(profile::Profile{}, {.journal = old});
    restartInto(again, before);
    again.run(Seconds(0.5));
    EXPECT_FALSE(again.control.status().azimuth.turnKnown);
    EXPECT_TRUE(again.control.status().elevation.turnKnown);
}

}  // namespace
}  // namespace boresight

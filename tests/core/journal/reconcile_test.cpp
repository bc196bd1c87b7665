// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/reconcile.h"

#include "tests/core/journal/reconcile_scene.h"

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

// When the wrap of an axis is certain, and when it is not. reconcile_question_test.cpp has the question to the operator
// in that case.
namespace boresight::journal {
namespace {

using moteus::HomeState;
using pointing::AxisGeometry;
using pointing::GearIn;
using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Ambiguity, IsOneTurnOfTheRotorOrOfTheOutput)
{
    const auto degrees = [](const AxisGeometry& axis, double ratio, bool encoder) {
        return ambiguity(axis, ratio, encoder).degrees();
    };
    AxisGeometry axis{.sign = -1, .offset = 17_deg};
    EXPECT_NEAR(degrees(axis, 1.0, false), 360.0, 1e-9);
    EXPECT_NEAR(degrees(axis, 0.2, false), 72.0, 1e-9);
    EXPECT_NEAR(degrees(axis, 0.01, false), 3.6, 1e-9);
    EXPECT_NEAR(degrees(axis, 0.01, true), 360.0, 1e-9);
    axis.gearIn = GearIn::Host;
    axis.gearRatio = 100.0;
    EXPECT_NEAR(degrees(axis, 1.0, false), 3.6, 1e-9);
}

TEST(Reconcile, ATrustedPositionIsTaken)
{
    Scene scene(Kind::HundredToOne);
    scene.powerCycledAt(1.2).evidence.record.reset();
    scene.evidence.trusted = true;
    EXPECT_THAT(scene.certain(), isAt(1.2));
    scene.frame.homeState = HomeState::Relative;  // the drive has not read its encoder yet
    EXPECT_EQ(scene.certain(), std::nullopt);
}

// ---- the drive kept its power ------------------------------------------------------------------------------------

struct KindCase
{
    const char* name;
    Kind kind;

    friend void PrintTo(const KindCase& test, std::ostream* out) { *out << test.name; }
};

class ReconcileKinds : public testing::TestWithParam<KindCase>
{};

INSTANTIATE_TEST_SUITE_P(All, ReconcileKinds,
                         testing::Values(KindCase{"OutputEncoder", Kind::OutputEncoder},
                                         KindCase{"FiveToOne", Kind::FiveToOne},
                                         KindCase{"HundredToOne", Kind::HundredToOne}),
                         [](const testing::TestParamInfo<KindCase>& test) { return test.param.name; });

// The program was killed or ended, or the bus was cut. A drive with power counts on, after a clean end or not, moved by
// hand or not.
// REQ-MEMORY-05 (ReconcileKinds.*): A drive that kept its power, and whose position nobody set, counts on. This also
// holds for an axis that was moving, and for one that was moved by hand.
TEST_P(ReconcileKinds, APoweredDriveCountsOn)
{
    for (const bool moving : {false, true}) {
        for (const double now : {405.0, 404.0, 45.0, 100.0, -300.0}) {
            Scene scene(GetParam().kind);
            scene.evidence.record->moving = moving;
            scene.frame.reported = turnsAt(now);
            EXPECT_THAT(scene.certain(), isAt(now));
        }
    }
}

// The wrap may be stored in the journal only: at 405° the drive counts 45°.
TEST_P(ReconcileKinds, CountsOnFromTheJournalNotFromZero)
{
    Scene scene(GetParam().kind);
    scene.evidence.record->reported = turnsAt(45.0);
    scene.evidence.record->counted = 45_deg;
    scene.frame.reported = turnsAt(55.0);
    EXPECT_THAT(scene.certain(), isAt(415.0));
}

TEST_P(ReconcileKinds, CountsInTheDirectionOfTheProfile)
{
    Scene scene(GetParam().kind);
    scene.axis.sign = -1;
    scene.axis.offset = 15_deg;
    scene.evidence.record->reported = scene.axis.toMotor(405_deg);
    scene.frame.reported = scene.evidence.record->reported + MotorTurns::fromTurns(0.25);
    EXPECT_THAT(scene.certain(), isAt(315.0));
}

TEST_P(ReconcileKinds, WhatIsRecordedIsCountedOn)
{
    Scene scene(GetParam().kind);
    scene.axis.sign = -1;
    scene.axis.offset = 15_deg;
    scene.evidence.record = recordOf(scene.frame, 33_deg, scene.axis, false, scene.evidence.now, scene.evidence.host);
    EXPECT_THAT(scene.certain(), isAt(33.0));
}

TEST_P(ReconcileKinds, ADriveThatWasRestartedMustBeAskedAbout)
{
    Scene scene(GetParam().kind);
    scene.powerCycledAt(405.0);
    EXPECT_EQ(scene.certain(), std::nullopt);
    EXPECT_THAT(scene.sentences(), Contains("The drive was restarted 34 s ago"));
}

TEST_P(ReconcileKinds, ADoubtMustBeAskedAboutAndNothingIsProposed)
{
    Scene scene(GetParam().kind);
    scene.evidence.doubt = QStringLiteral("The encoder jumped by 12.3°");
    const TurnQuestion question = scene.question();
    EXPECT_EQ(question.evidence.front(), *scene.evidence.doubt);
    EXPECT_EQ(question.proposed, std::nullopt);
}

// `d nearest` and `d exact` shift the count without moving the axis. An older record would be wrong by a turn or more.
TEST_P(ReconcileKinds, APositionSetSinceTheJournalIsNotCountedOver)
{
    for (const double place : {45.0, 405.0 - 3.6, 405.0 + 7.0, 100.0}) {
        Scene scene(GetParam().kind);
        scene.setTo(place);
        EXPECT_THAT(scene.sentences(),
                    Contains("The position of the drive was set by a command. The change is not a motion"));
        EXPECT_EQ(scene.question().proposed, std::nullopt) << place;
    }
}

// Story: the axis was turned by 216° by hand and its old position value was set again. Its position was called certain,
// and was wrong.
TEST_P(ReconcileKinds, MovedAndSetBackIsNotTakenForUnmoved)
{
    Scene scene(GetParam().kind);
    scene.frame.reported = turnsAt(189.0);
    scene.setTo(405.0);
    EXPECT_EQ(scene.frame.reported, scene.evidence.record->reported);
    EXPECT_EQ(scene.question().proposed, std::nullopt);
}

// `d nearest` keeps the phase of the encoder, `d exact` does not. After `d exact` the operator may enter any angle.
TEST(Reconcile, APhaseThatWasThrownAwayContradictsNobody)
{
    EXPECT_FALSE(Scene(Kind::FiveToOne).setTo(333.0).question().candidates.empty());
    EXPECT_TRUE(Scene(Kind::FiveToOne).setTo(350.0).question().candidates.empty());
    EXPECT_THAT(Scene(Kind::FiveToOne).setTo(350.0).sentences(),
                Contains("The drive does not know the position of the axis. Enter the angle"));
}

// A computer that restarted without a time server does not know the time, but it still detects a position that was set.
TEST_P(ReconcileKinds, APositionSetIsSeenWhateverTheClocksSay)
{
    Scene scene(GetParam().kind);
    scene.frame.reported = turnsAt(189.0);
    scene.setTo(405.0).hostRestarted(false, false);
    EXPECT_THAT(scene.sentences(),
                Contains("The position of the drive was set by a command. The change is not a motion"));
    EXPECT_EQ(scene.question().proposed, std::nullopt);
}

// The encoder on the output failed and came back. Meanwhile the drive used the encoder of the rotor.
TEST(Reconcile, AZeroThatWasLostIsNotCountedOver)
{
    Scene scene(Kind::HundredToOne);
    scene.evidence.record->homeState = HomeState::Output;
    EXPECT_THAT(scene.sentences(), Contains("The zero of the drive was set or lost after the journal was written"));
}

// With other encoder settings the drive counts from zero again, and its origin can have any value.
TEST_P(ReconcileKinds, EncodersSetAnewAreNotCountedOver)
{
    Scene scene(GetParam().kind);
    ++scene.frame.origin->beginning;
    EXPECT_THAT(scene.sentences(),
                Contains("The encoder settings of the drive were changed. It counts from a new zero"));
    EXPECT_TRUE(scene.question().candidates.empty());
}

TEST_P(ReconcileKinds, ADriveThatDoesNotTellItsOriginMustBeAskedAbout)
{
    Scene now(GetParam().kind);
    now.frame.origin.reset();
    EXPECT_THAT(now.sentences(), Contains("The drive did not report whether its position was set since then"));
    Scene then(GetParam().kind);
    then.evidence.record->origin.reset();
    EXPECT_EQ(then.certain(), std::nullopt);
}

TEST_P(ReconcileKinds, AChangedProfileIsNotCountedOver)
{
    Scene scene(GetParam().kind);
    scene.axis.offset = scene.frame.period;  // a comparison within one period would see no difference
    EXPECT_THAT(scene.sentences(),
                Contains("Zero, direction or gear of the axis were changed after the journal was written"));
}

TEST_P(ReconcileKinds, AnotherDriveIsNotCountedOver)
{
    Scene scene(GetParam().kind);
    scene.frame.drive = kElevationDrive;
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("The journal is of another drive (6f1c2a90-")));
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    scene.frame.drive.clear();  // the identity of the drive is unknown, and two unknown drives are not the same
    scene.evidence.record->drive.clear();
    EXPECT_EQ(scene.question().proposed, std::nullopt);
}

TEST_P(ReconcileKinds, AHomeStateOfRelativeKnowsNothing)
{
    Scene scene(GetParam().kind);
    scene.frame.homeState = scene.evidence.record->homeState = HomeState::Relative;
    const TurnQuestion question = scene.question();
    EXPECT_TRUE(question.candidates.empty());
    EXPECT_EQ(question.proposed, std::nullopt);
    EXPECT_THAT(scene.sentences(), Contains("The drive does not know the position of the axis. Enter the angle"));
}

TEST(Reconcile, AnOutputEncoderThatWasNotFoundYetTellsNoDirection)
{
    Scene scene;
    scene.frame.homeState = scene.evidence.record->homeState = HomeState::Rotor;
    EXPECT_TRUE(scene.question().candidates.empty());
}

// ---- clocks ------------------------------------------------------------------------------------------------------

// The drive lost its power 10 min ago, and meanwhile the axis was turned by 360°, so 405° would be wrong. The clock of
// the computer may show any time.
// REQ-MEMORY-06 (ReconcileClock.*): No step or restart of a clock makes the position of a restarted drive certain.
TEST(ReconcileClock, NoStepOfTheClockMakesARestartedDriveCertain)
{
    for (int step = -100000; step <= 100000; step += 7) {
        Scene scene(Kind::HundredToOne);
        scene.powerCycledAt(45.0).frame.uptime = minutes(10);
        scene.clockStepped(seconds(step));
        ASSERT_EQ(scene.certain(), std::nullopt) << step << " s";
    }
}

// The worst case: a drive and a computer without a clock battery share one switch. They start together, and the clock
// always starts at the same time. So by UTC the drive seems to have started at the same time as in the record.
TEST(ReconcileClock, AComputerThatStartsAtTheSameTimeEachDayIsNoWitness)
{
    Scene scene(Kind::HundredToOne);
    scene.evidence.record->uptime = seconds(600);
    scene.evidence.record->host.sinceBoot = seconds(590);
    scene.evidence.record->when = kWhen;
    scene.powerCycledAt(45.0).hostRestarted(false, false);
    scene.frame.uptime = seconds(700);
    scene.evidence.host.sinceBoot = seconds(690);
    scene.evidence.now = kWhen + seconds(100);
    EXPECT_EQ(scene.certain(), std::nullopt);
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("its clock is not synchronised")));
}

TEST(ReconcileClock, AfterARestartOfTheComputerUtcCountsIfATimeServerKeptItBothTimes)
{
    EXPECT_THAT(Scene(Kind::HundredToOne).hostRestarted(true, true).certain(), isAt(405.0));
    EXPECT_EQ(Scene(Kind::HundredToOne).hostRestarted(false, true).certain(), std::nullopt);
    EXPECT_EQ(Scene(Kind::HundredToOne).hostRestarted(true, false).certain(), std::nullopt);
    EXPECT_EQ(Scene(Kind::HundredToOne).hostRestarted(true, true).clockStepped(minutes(-5)).certain(), std::nullopt);
    EXPECT_EQ(Scene(Kind::HundredToOne).hostRestarted(true, true).clockStepped(minutes(5)).certain(), std::nullopt);
}

TEST(ReconcileClock, ARecordOfTheFutureIsNotCountedOn)
{
    Scene scene;
    scene.clockStepped(minutes(-30));
    EXPECT_THAT(scene.sentences(),
                Contains("The journal is dated 18 min in the future. The clock of this computer was set back"));
    EXPECT_THAT(scene.sentences(), Contains("The journal has 405.0°, written at standstill"));
}

// A step forward that is shorter than the drive has been on does no harm: the steady clock shows the elapsed time.
TEST(ReconcileClock, ASmallStepDoesNoHarmWhileTheComputerRuns)
{
    EXPECT_THAT(Scene().clockStepped(minutes(40)).certain(), isAt(405.0));
    EXPECT_THAT(Scene().clockStepped(minutes(-11)).certain(), isAt(405.0));
    EXPECT_EQ(Scene().clockStepped(hours(2)).certain(), std::nullopt);
}

// The steady clock may stop while the computer is suspended, here for 3 h. The drive restarted an hour ago. By the
// steady clock it could have been on all the time.
TEST(ReconcileClock, ASleepOfTheComputerIsSeenByUtc)
{
    Scene scene(Kind::HundredToOne);
    scene.powerCycledAt(45.0).clockStepped(hours(3));
    scene.frame.uptime = hours(1);
    EXPECT_EQ(scene.certain(), std::nullopt);
}

TEST(ReconcileClock, TheDrivesOscillatorMayBeOffByTwoPercent)
{
    for (const double rate : {0.98, 1.0, 1.015}) {
        Scene scene;
        scene.frame.uptime = scene.evidence.record->uptime + Seconds(minutes(12)) * rate;
        EXPECT_THAT(scene.certain(), isAt(405.0)) << rate;
    }
    Scene scene;
    scene.frame.uptime = scene.evidence.record->uptime + Seconds(minutes(12)) * 1.05;
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("The clocks of the drive and of this computer disagree")));
}

// 12 min × 1.02 + 5 s = 739.4 s: a drive that has been on just longer was on before the record.
TEST(ReconcileClock, TheDriveMustHaveStartedClearlyBeforeTheRecord)
{
    const auto uptimes = [](double now) {
        Scene scene;
        scene.evidence.record->uptime = Seconds(now) - minutes(12);
        scene.frame.uptime = Seconds(now);
        return scene.certain();
    };
    EXPECT_EQ(uptimes(739.3), std::nullopt);
    EXPECT_THAT(uptimes(739.5), isAt(405.0));
}

TEST(ReconcileClock, AnUptimeThatStartedAgainIsNotTakenForARestartNorForProof)
{
    Scene scene;
    const Seconds period(4294967.296);
    scene.evidence.record->uptime = period - Seconds(minutes(10));
    scene.frame.uptime = minutes(2);
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("The clock of the drive restarts every 49.7 days")));
    EXPECT_THAT(scene.sentences(), Not(Contains(HasSubstr("restarted"))));
    EXPECT_THAT(scene.question().proposed, proposes(405.0));
    // Both times are on the same side of the overflow: nothing special.
    scene.evidence.record->uptime = period - Seconds(hours(1));
    scene.frame.uptime = period - Seconds(minutes(48));
    EXPECT_THAT(scene.certain(), isAt(405.0));
}

TEST(ReconcileClock, RubbishInTheNumbersIsNeverCertain)
{
    const double nan = std::nan("");
    Scene scene(Kind::HundredToOne);
    scene.frame.uptime = Seconds(nan);
    EXPECT_EQ(scene.certain(), std::nullopt);
    scene = Scene(Kind::HundredToOne);
    scene.frame.reported = MotorTurns::fromTurns(nan);
    EXPECT_TRUE(scene.question().candidates.empty());
    scene = Scene(Kind::HundredToOne);
    scene.evidence.record->host.sinceBoot = hours(20) + minutes(1);  // later than now on a clock that only goes forward
    scene.frame.uptime = scene.evidence.record->uptime - minutes(1);  // and the uptime of the drive seems to agree
    EXPECT_EQ(scene.certain(), std::nullopt);
    for (const double period : {0.0, nan, -3.6, 1e-9}) {
        scene = Scene(Kind::HundredToOne);
        scene.frame.period = Angle::fromDegrees(period);
        EXPECT_EQ(scene.certain(), std::nullopt) << period;
        EXPECT_TRUE(inDegrees(std::get<TurnQuestion>(scene.judged()).candidates).empty()) << period;
    }
}

}  // namespace
}  // namespace boresight::journal

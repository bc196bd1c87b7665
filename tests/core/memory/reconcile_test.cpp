// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/reconcile.h"

#include "tests/core/memory/example_memory.h"

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

namespace boresight::memory {
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

// The mount of scenario S10, with three kinds of drive. What the drive counts is the axis, from -0.5 to 0.5 of its
// ambiguity at power-up.
enum class Kind
{
    OutputEncoder,  // 360°
    FiveToOne,      // 72°
    HundredToOne    // 3.6°
};

double ratioOf(Kind kind)
{
    return kind == Kind::OutputEncoder ? 1.0 : kind == Kind::FiveToOne ? 0.2 : 0.01;
}

// Until its zero is set, which only AZeroSetSinceTheJournalIsNotCountedOver does.
HomeState homeStateOf(Kind kind)
{
    return kind == Kind::OutputEncoder ? HomeState::Output : HomeState::Rotor;
}

AxisGeometry axisOf()
{
    return {.travel = {Angle::fromDegrees(-360.0), Angle::fromDegrees(450.0)}};
}

MotorTurns turnsAt(double degrees)
{
    return MotorTurns::fromTurns(degrees / 360.0);
}

// A journal of 12 minutes ago and a drive that has been on for an hour and counted all that time: unmoved at 405°.
struct Scene
{
    explicit Scene(Kind kind = Kind::OutputEncoder)
        : frame{.drive = kAzimuthDrive,
                .reported = turnsAt(405.0),
                .homeState = homeStateOf(kind),
                .uptime = hours(1),
                .outputEncoder = kind == Kind::OutputEncoder,
                .period = ambiguity(axisOf(), ratioOf(kind), kind == Kind::OutputEncoder)},
          evidence{.record = TurnRecord{.drive = kAzimuthDrive,
                                        .angle = 405_deg,
                                        .reported = turnsAt(405.0),
                                        .counted = 405_deg,
                                        .uptime = hours(1) - minutes(12),
                                        .homeState = homeStateOf(kind),
                                        .when = kWhen - minutes(12),
                                        .host = {.boot = kBoot, .sinceBoot = hours(20) - minutes(12)}},
                   .now = kWhen,
                   .host = {.boot = kBoot, .sinceBoot = hours(20)}}
    {}

    // Power came back 34 s ago and the axis stands at `degrees`: the drive counts within half its ambiguity of zero.
    Scene& powerCycledAt(double degrees)
    {
        const double places = std::round(degrees / frame.period.degrees());
        frame.reported = turnsAt(degrees - places * frame.period.degrees());
        frame.uptime = seconds(34);
        return *this;
    }

    Scene& dirty()
    {
        evidence.record->moving = true;
        return *this;
    }

    Scene& clockStepped(Seconds step)
    {
        evidence.now += std::chrono::duration_cast<UtcTime::duration>(step);
        return *this;
    }

    // The computer was restarted 5 min ago.
    Scene& hostRestarted(bool thenExact, bool nowExact)
    {
        evidence.record->host.utcIsExact = thenExact;
        evidence.host = {.boot = kElevationDrive, .sinceBoot = minutes(5), .utcIsExact = nowExact};
        return *this;
    }

    [[nodiscard]] Judgement judged() const { return reconcile(frame, evidence, axis); }

    [[nodiscard]] TurnQuestion question() const
    {
        const Judgement judgement = judged();
        const auto* asked = std::get_if<TurnQuestion>(&judgement);
        if (asked == nullptr) {
            ADD_FAILURE() << "certain: " << std::get<Certain>(judgement).why.toStdString();
            return {};
        }
        EXPECT_EQ(asked->period, frame.period);
        EXPECT_EQ(asked->movedSince, Angle());
        return *asked;
    }

    // In degrees; nothing if it is a question.
    [[nodiscard]] std::optional<double> certain() const
    {
        const Judgement judgement = judged();
        const auto* known = std::get_if<Certain>(&judgement);
        return known != nullptr ? std::optional(known->angle.degrees()) : std::nullopt;
    }

    [[nodiscard]] std::vector<std::string> sentences() const
    {
        std::vector<std::string> all;
        for (const QString& sentence : question().evidence) {
            all.push_back(sentence.toStdString());
        }
        return all;
    }

    AxisGeometry axis = axisOf();
    DriveFrame frame;
    Evidence evidence;
};

std::vector<double> inDegrees(const std::vector<Angle>& angles)
{
    std::vector<double> all;
    for (const Angle angle : angles) {
        all.push_back(std::round(angle.degrees() * 1e6) / 1e6);
    }
    return all;
}

testing::Matcher<std::optional<double>> isAt(double degrees)
{
    return testing::Optional(testing::DoubleNear(degrees, 1e-6));
}

testing::Matcher<std::optional<Angle>> proposes(double degrees)
{
    return testing::Optional(
        testing::ResultOf([](Angle angle) { return angle.degrees(); }, testing::DoubleNear(degrees, 1e-6)));
}

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
    scene.frame.homeState = HomeState::Relative;  // it has not even looked at its encoder
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

// The program was killed or ended, or the bus was cut: a powered drive counts on, clean or not, moved by hand or not.
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

// The turn may be kept on our side only: 405° is counted as 45°.
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

// `d nearest` and `d exact` shift the count by whole turns without moving the axis: a record from before would be a
// turn or more off. The home state tells.
TEST_P(ReconcileKinds, AZeroSetSinceTheJournalIsNotCountedOver)
{
    Scene scene(GetParam().kind);
    scene.evidence.record->homeState = HomeState::Rotor;
    scene.frame.homeState = HomeState::Output;
    EXPECT_THAT(scene.sentences(), Contains("The drive's zero was set or lost since the journal was written"));
}

TEST_P(ReconcileKinds, AChangedProfileIsNotCountedOver)
{
    Scene scene(GetParam().kind);
    scene.axis.offset = scene.frame.period;  // would look the same to a comparison within one place
    EXPECT_THAT(scene.sentences(),
                Contains("Zero, direction or gear of the axis were changed since the journal was written"));
}

TEST_P(ReconcileKinds, AnotherDriveIsNotCountedOver)
{
    Scene scene(GetParam().kind);
    scene.frame.drive = kElevationDrive;
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("The journal is of another drive (6f1c2a90-")));
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    scene.frame.drive.clear();  // who it is was not found out: two unknown drives are not the same
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
    EXPECT_THAT(scene.sentences(), Contains("The drive does not know where the axis is: enter the angle"));
}

TEST(Reconcile, AnOutputEncoderThatWasNotFoundYetTellsNoDirection)
{
    Scene scene;
    scene.frame.homeState = scene.evidence.record->homeState = HomeState::Rotor;
    EXPECT_TRUE(scene.question().candidates.empty());
}

// ---- clocks ------------------------------------------------------------------------------------------------------

// The drive lost its power 10 min ago and the axis was turned by 360° meanwhile, so 405° would be wrong. The clock of
// the computer says whatever it likes.
TEST(ReconcileClock, NoStepOfTheClockMakesARestartedDriveCertain)
{
    for (int step = -100000; step <= 100000; step += 7) {
        Scene scene(Kind::HundredToOne);
        scene.powerCycledAt(45.0).frame.uptime = minutes(10);
        scene.clockStepped(seconds(step));
        ASSERT_EQ(scene.certain(), std::nullopt) << step << " s";
    }
}

// Worst of all: a computer without a battery clock and a drive on one switch. Both start together, the clock always at
// the same time, so that by UTC the drive of today began just when the one of the record did.
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
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("no time server vouches for its clock")));
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
                Contains("The journal is dated 18 min in the future: this computer's clock was put back"));
    EXPECT_THAT(scene.sentences(), Contains("The journal says 405.0°, written at rest"));
}

// A step forward by less than the drive has been on does no harm: the steady clock says what time went by.
TEST(ReconcileClock, ASmallStepDoesNoHarmWhileTheComputerRuns)
{
    EXPECT_THAT(Scene().clockStepped(minutes(40)).certain(), isAt(405.0));
    EXPECT_THAT(Scene().clockStepped(minutes(-11)).certain(), isAt(405.0));
    EXPECT_EQ(Scene().clockStepped(hours(2)).certain(), std::nullopt);
}

// The steady clock may stand still while the computer sleeps. 3 h of sleep; the drive was restarted an
// hour ago, which by the steady clock would fit it having been on all the time.
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

// 12 min × 1.02 + 5 s = 739.4 s: a drive on for just longer was on before the record.
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
    EXPECT_THAT(scene.sentences(), Contains(HasSubstr("The drive's clock starts again every 49.7 days")));
    EXPECT_THAT(scene.sentences(), Not(Contains(HasSubstr("was restarted"))));
    EXPECT_THAT(scene.question().proposed, proposes(405.0));
    // Both on the same side of it: nothing special.
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
    scene.evidence.record->host.sinceBoot =
        hours(20) + minutes(1);  // later than now on a clock that only goes forward,
    scene.frame.uptime = scene.evidence.record->uptime - minutes(1);  // and the drive seems to agree
    EXPECT_EQ(scene.certain(), std::nullopt);
    for (const double period : {0.0, nan, -3.6, 1e-9}) {
        scene = Scene(Kind::HundredToOne);
        scene.frame.period = Angle::fromDegrees(period);
        EXPECT_EQ(scene.certain(), std::nullopt) << period;
        EXPECT_TRUE(inDegrees(std::get<TurnQuestion>(scene.judged()).candidates).empty()) << period;
    }
}

// ---- only one turn within the travel --------------------------------------------------------------------------------

struct OnlyCase
{
    const char* name;
    std::optional<double> journal;
    QString drive;
    std::optional<double> expected;

    friend void PrintTo(const OnlyCase& test, std::ostream* out) { *out << test.name; }
};

class ReconcileOnlyPlace : public testing::TestWithParam<OnlyCase>
{};

// An elevation of 0…90° that stands at 30° when its power comes back.
Scene elevationAt30(const OnlyCase& test)
{
    Scene scene;
    scene.axis.travel = {0_deg, 90_deg};
    scene.powerCycledAt(30.0);
    if (test.journal) {
        scene.evidence.record->angle = Angle::fromDegrees(*test.journal);
        scene.evidence.record->reported = turnsAt(*test.journal);
        scene.evidence.record->drive = test.drive;
    } else {
        scene.evidence.record.reset();
    }
    return scene;
}

TEST_P(ReconcileOnlyPlace, IsCertainUnlessTheJournalSpeaksAgainstIt)
{
    const auto certain = elevationAt30(GetParam()).certain();
    ASSERT_EQ(certain.has_value(), GetParam().expected.has_value());
    if (certain) {
        EXPECT_NEAR(*certain, *GetParam().expected, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ReconcileOnlyPlace,
                         testing::Values(OnlyCase{"NoJournal", std::nullopt, {}, 30.0},
                                         OnlyCase{"Unmoved", 30.0, kAzimuthDrive, 30.0},
                                         OnlyCase{"Sagged", 34.9, kAzimuthDrive, 30.0},
                                         OnlyCase{"Moved", 35.1, kAzimuthDrive, std::nullopt},
                                         OnlyCase{"OtherDrive", 30.0, kElevationDrive, std::nullopt}),
                         [](const testing::TestParamInfo<OnlyCase>& test) { return test.param.name; });

TEST(ReconcileOnlyPlace, ARotorEncoderIsNotEnough)
{
    Scene scene(Kind::FiveToOne);
    scene.axis.travel = {0_deg, 60_deg};
    scene.powerCycledAt(30.0).evidence.record.reset();
    const TurnQuestion question = scene.question();
    EXPECT_THAT(inDegrees(question.candidates), ElementsAre(30.0));
    EXPECT_EQ(scene.sentences().front(), "The drive reports a place that is possible at 30.0° only");
}

// Scenario S10 with a mount of one turn: two places near the end, one elsewhere.
TEST(ReconcileOnlyPlace, TheEndsOfTheTravelCountThreeDegreesMore)
{
    Scene scene;
    scene.axis.travel = {0_deg, 360_deg};
    scene.evidence.record.reset();
    EXPECT_THAT(scene.powerCycledAt(4.0).certain(), isAt(4.0));
    EXPECT_THAT(inDegrees(scene.powerCycledAt(2.9).question().candidates), ElementsAre(2.9, 362.9));
    EXPECT_THAT(inDegrees(scene.powerCycledAt(-2.9).question().candidates), ElementsAre(-2.9, 357.1));
}

// ---- the question -----------------------------------------------------------------------------------------------

TEST(ReconcileQuestion, SaysWhatScenario10Says)
{
    Scene scene;
    scene.dirty().powerCycledAt(405.0).evidence.sensorHeading = Angle::fromDegrees(98.0);
    const TurnQuestion question = scene.question();
    EXPECT_THAT(inDegrees(question.candidates), ElementsAre(-315.0, 45.0, 405.0));
    EXPECT_THAT(question.proposed, proposes(405.0));
    EXPECT_THAT(scene.sentences(),
                ElementsAre("Direction 45.0° is known, the turn is not: -315.0°, 45.0° or 405.0° are possible",
                            "The journal says 405.0°, 12 min old, written while moving",
                            "The drive was restarted 34 s ago", "The sensor says 98.0°"));
}

TEST(ReconcileQuestion, MovedByHandHasNoDefault)
{
    Scene scene;
    scene.powerCycledAt(100.0);
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    EXPECT_THAT(inDegrees(scene.question().candidates), ElementsAre(-260.0, 100.0));
    EXPECT_THAT(scene.sentences(),
                Contains("The nearest of them is 305.0° from the journal: the axis was moved meanwhile"));
    EXPECT_THAT(scene.sentences(), Contains("There is no sensor to compare with"));
}

// Nobody can tell a whole turn from none: so it is a question, even when clean and proposed.
TEST(ReconcileQuestion, MovedByAFullTurnLooksUnmovedAndIsThereforeAsked)
{
    EXPECT_THAT(Scene().powerCycledAt(45.0).question().proposed, proposes(405.0));
    EXPECT_THAT(Scene(Kind::HundredToOne).powerCycledAt(405.0 - 3.6).question().proposed, proposes(405.0));
}

struct ProposalCase
{
    const char* name;
    Kind kind;
    bool moving;
    double now;
    std::optional<double> proposed;

    friend void PrintTo(const ProposalCase& test, std::ostream* out) { *out << test.name; }
};

class ReconcileProposal : public testing::TestWithParam<ProposalCase>
{};

TEST_P(ReconcileProposal, IsTheJournalsTurnWhereItAgrees)
{
    const ProposalCase& test = GetParam();
    Scene scene(test.kind);
    scene.evidence.record->moving = test.moving;
    const auto proposed = scene.powerCycledAt(test.now).question().proposed;
    ASSERT_EQ(proposed.has_value(), test.proposed.has_value());
    if (proposed) {
        EXPECT_NEAR(proposed->degrees(), *test.proposed, 1e-6);
    }
}

// The journal says 405°.
INSTANTIATE_TEST_SUITE_P(
    All, ReconcileProposal,
    testing::Values(ProposalCase{"OutputCleanUnmoved", Kind::OutputEncoder, false, 405.0, 405.0},
                    ProposalCase{"OutputCleanWithinFive", Kind::OutputEncoder, false, 400.1, 400.1},
                    ProposalCase{"OutputCleanBeyondFive", Kind::OutputEncoder, false, 399.9, std::nullopt},
                    ProposalCase{"OutputDirtyUnmoved", Kind::OutputEncoder, true, 405.0, 405.0},
                    ProposalCase{"OutputDirtyCoasted", Kind::OutputEncoder, true, 409.9, 409.9},
                    ProposalCase{"OutputDirtyMoved", Kind::OutputEncoder, true, 200.0, std::nullopt},
                    ProposalCase{"FiveToOneCleanUnmoved", Kind::FiveToOne, false, 405.0, 405.0},
                    ProposalCase{"FiveToOneDirtyUnmoved", Kind::FiveToOne, true, 405.0, 405.0},
                    ProposalCase{"FiveToOneCleanMovedByOneRotorTurn", Kind::FiveToOne, false, 333.0, 405.0},
                    ProposalCase{"FiveToOneCleanMoved", Kind::FiveToOne, false, 380.0, std::nullopt},
                    ProposalCase{"HundredCleanUnmoved", Kind::HundredToOne, false, 405.0, 405.0},
                    ProposalCase{"HundredCleanWithinAQuarter", Kind::HundredToOne, false, 405.8, 405.8},
                    ProposalCase{"HundredCleanBeyondAQuarter", Kind::HundredToOne, false, 406.0, std::nullopt},
                    ProposalCase{"HundredDirtyUnmoved", Kind::HundredToOne, true, 405.0, std::nullopt}),
    [](const testing::TestParamInfo<ProposalCase>& test) { return test.param.name; });

TEST(ReconcileQuestion, ADirtyJournalOfAHighGearSaysWhyItProposesNothing)
{
    const auto sentences = Scene(Kind::HundredToOne).dirty().powerCycledAt(405.0).sentences();
    EXPECT_THAT(sentences,
                Contains("The axis was moving, and places 3.6° apart look the same to the drive: the journal "
                         "cannot tell which"));
    EXPECT_EQ(sentences.front(),
              "The angle is known to a multiple of 3.6° only: 227 places from -361.8° to 451.8° are possible");
}

TEST(ReconcileQuestion, WithoutAJournalSaysSoAndProposesNothing)
{
    Scene scene(Kind::FiveToOne);
    scene.powerCycledAt(405.0).evidence.record.reset();
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    EXPECT_THAT(scene.sentences(), Contains("The journal says nothing about this axis"));
    scene.evidence.recordProblem = QStringLiteral("The journal file x is missing");
    EXPECT_THAT(scene.sentences(), Contains("The journal file x is missing"));
    EXPECT_THAT(scene.sentences(), Not(Contains("The journal says nothing about this axis")));
}

TEST(ReconcileQuestion, AnOlderGenerationOfTheJournalSaysBoth)
{
    Scene scene;
    scene.dirty().powerCycledAt(405.0).evidence.recordProblem =
        QStringLiteral("The journal file x cannot be used: torn");
    EXPECT_THAT(scene.sentences(), Contains("The journal file x cannot be used: torn"));
    EXPECT_THAT(scene.sentences(), Contains("The journal says 405.0°, 12 min old, written while moving"));
}

TEST(ReconcileQuestion, AnotherDriveWithPowerProposesNothing)
{
    Scene scene(Kind::FiveToOne);
    scene.powerCycledAt(405.0).frame.drive = kElevationDrive;
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    EXPECT_FALSE(scene.question().candidates.empty());
}

TEST(ReconcileQuestion, NoTurnWithinTheTravelAsksForTheAngle)
{
    Scene scene;
    scene.axis.travel = {0_deg, 90_deg};
    scene.evidence.record.reset();
    scene.powerCycledAt(120.0);
    EXPECT_TRUE(scene.question().candidates.empty());
    EXPECT_EQ(scene.sentences().front(),
              "The drive reports 120.0°, and no turn of that lies within the travel: enter the angle");
}

TEST(ReconcileQuestion, ManyCandidatesAreAllKept)
{
    Scene scene(Kind::HundredToOne);
    scene.frame.period = ambiguity(scene.axis, 0.001, false);
    scene.powerCycledAt(0.0);
    EXPECT_EQ(scene.question().candidates.size(), 2267U);  // 816° of 0.36°
}

TEST(ReconcileQuestion, AgesAreTold)
{
    const auto says = [](Seconds age, const char* text) {
        Scene scene;
        scene.powerCycledAt(405.0).evidence.record->when = kWhen - std::chrono::duration_cast<UtcTime::duration>(age);
        EXPECT_THAT(scene.sentences(), Contains(HasSubstr(text)));
    };
    says(seconds(0), "405.0°, 0 s old");
    says(seconds(119), "405.0°, 119 s old");
    says(minutes(90), "405.0°, 90 min old");
    says(hours(47), "405.0°, 47 h old");
    says(hours(72), "405.0°, 3 days old");
}

}  // namespace
}  // namespace boresight::memory

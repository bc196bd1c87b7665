// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/reconcile.h"
#include "tests/core/journal/reconcile_scene.h"

#include <gmock/gmock.h>

#include <ostream>

// The question to the operator when the wrap of an axis is not certain: the candidates, the proposal and its evidence.
namespace boresight::journal {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// REQ-MEMORY-08 (ReconcileQuestion.*): If the wrap is not certain, the operator is asked. The question lists all
// possible positions, and the evidence in words. It proposes one of them only if the journal agrees.
TEST(ReconcileQuestion, SaysWhatScenario10Says)
{
    Scene scene;
    scene.dirty().powerCycledAt(405.0).evidence.sensorHeading = Angle::fromDegrees(98.0);
    const TurnQuestion question = scene.question();
    EXPECT_THAT(inDegrees(question.candidates), ElementsAre(-315.0, 45.0, 405.0));
    EXPECT_THAT(question.proposed, proposes(405.0));
    EXPECT_THAT(scene.sentences(),
                ElementsAre("Direction 45.0° is known, but not the cable wrap. -315.0°, 45.0° or 405.0° are possible",
                            "The journal has 405.0°, 12 min old, written in motion", "The drive was restarted 34 s ago",
                            "The sensor reports 98.0°"));
}

TEST(ReconcileQuestion, MovedByHandHasNoDefault)
{
    Scene scene;
    scene.powerCycledAt(100.0);
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    EXPECT_THAT(inDegrees(scene.question().candidates), ElementsAre(-260.0, 100.0, 460.0));
    EXPECT_THAT(scene.sentences(), Contains("The nearest possible position is 55.0° from the position in the journal. "
                                            "The axis moved while Boresight did not watch it"));
    EXPECT_THAT(scene.sentences(), Contains("There is no sensor to compare with"));
}

// Nothing distinguishes a motion of a full turn from no motion. So Boresight asks, even after a clean end and with a
// proposal.
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

// REQ-MEMORY-08 (ReconcileProposal.*)
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
                    ProposalCase{"FiveToOneCleanSagged", Kind::FiveToOne, false, 403.3, 403.3},
                    ProposalCase{"FiveToOneCleanMoved", Kind::FiveToOne, false, 403.1, std::nullopt},
                    ProposalCase{"HundredCleanUnmoved", Kind::HundredToOne, false, 405.0, 405.0},
                    ProposalCase{"HundredCleanWithinLuck", Kind::HundredToOne, false, 405.08, 405.08},
                    ProposalCase{"HundredCleanMoved", Kind::HundredToOne, false, 405.1, std::nullopt},
                    ProposalCase{"HundredDirtyUnmoved", Kind::HundredToOne, true, 405.0, std::nullopt}),
    [](const testing::TestParamInfo<ProposalCase>& test) { return test.param.name; });

TEST(ReconcileQuestion, ADirtyJournalOfAHighGearSaysWhyItProposesNothing)
{
    const auto sentences = Scene(Kind::HundredToOne).dirty().powerCycledAt(405.0).sentences();
    EXPECT_THAT(sentences, Contains("The axis may have moved since then. The drive cannot distinguish places 3.6° "
                                    "apart, so the journal does not show which place is right"));
    EXPECT_EQ(sentences.front(),
              "The angle is known only to a multiple of 3.6°. 233 places from -372.6° to 462.6° are possible");
}

TEST(ReconcileQuestion, WithoutAJournalSaysSoAndProposesNothing)
{
    Scene scene(Kind::FiveToOne);
    scene.powerCycledAt(405.0).evidence.record.reset();
    EXPECT_EQ(scene.question().proposed, std::nullopt);
    EXPECT_THAT(scene.sentences(), Contains("The journal has no entry for this axis"));
    scene.evidence.recordProblem = QStringLiteral("The journal file x is missing");
    EXPECT_THAT(scene.sentences(), Contains("The journal file x is missing"));
    EXPECT_THAT(scene.sentences(), Not(Contains("The journal has no entry for this axis")));
}

TEST(ReconcileQuestion, AnOlderGenerationOfTheJournalSaysBoth)
{
    Scene scene;
    scene.dirty().powerCycledAt(405.0).evidence.recordProblem =
        QStringLiteral("The journal file x cannot be used: torn");
    EXPECT_THAT(scene.sentences(), Contains("The journal file x cannot be used: torn"));
    EXPECT_THAT(scene.sentences(), Contains("The journal has 405.0°, 12 min old, written in motion"));
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
              "The drive reports 120.0°. No cable wrap of this angle lies within 15° of the travel. Enter the angle");
}

TEST(ReconcileQuestion, ManyCandidatesAreAllKept)
{
    Scene scene(Kind::HundredToOne);
    scene.frame.period = ambiguity(scene.axis, 0.001, false);
    scene.powerCycledAt(0.0);
    EXPECT_EQ(scene.question().candidates.size(), 2333U);  // 840° in steps of 0.36°
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

// ---- only one turn within the travel --------------------------------------------------------------------------------

struct OnlyCase
{
    const char* name;
    std::optional<double> journal;
    QString drive;
    std::optional<double> proposed;

    friend void PrintTo(const OnlyCase& test, std::ostream* out) { *out << test.name; }
};

class ReconcileOnlyPlace : public testing::TestWithParam<OnlyCase>
{};

// An elevation axis with a travel of 0…90° stands at 30° when its power comes back. Another tool may have set its
// position meanwhile, so the operator looks once and confirms once.
// REQ-MEMORY-07 (ReconcileOnlyPlace.*): If only one wrap lies within the travel, it is proposed where the encoder is on
// the output and no journal contradicts it.
TEST_P(ReconcileOnlyPlace, IsProposedUnlessTheJournalSpeaksAgainstIt)
{
    const OnlyCase& test = GetParam();
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
    const auto proposed = scene.question().proposed;
    ASSERT_EQ(proposed.has_value(), test.proposed.has_value());
    if (proposed) {
        EXPECT_NEAR(proposed->degrees(), *test.proposed, 1e-6);
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
    EXPECT_EQ(question.proposed, std::nullopt);
    EXPECT_EQ(scene.sentences().front(), "The position that the drive reports fits only 30.0°");
}

// Scenario S10 with a mount whose travel is one turn: two possible positions near the end, one elsewhere. An axis that
// coasted or was pushed can stand beyond its travel, at its mechanical stops.
TEST(ReconcileOnlyPlace, TheEndsOfTheTravelCountFifteenDegreesMore)
{
    Scene scene;
    scene.axis.travel = {0_deg, 360_deg};
    scene.evidence.record.reset();
    EXPECT_THAT(inDegrees(scene.powerCycledAt(16.0).question().candidates), ElementsAre(16.0));
    EXPECT_THAT(inDegrees(scene.powerCycledAt(14.9).question().candidates), ElementsAre(14.9, 374.9));
    EXPECT_THAT(inDegrees(scene.powerCycledAt(-14.9).question().candidates), ElementsAre(-14.9, 345.1));
    scene.evidence.trusted = true;
    EXPECT_THAT(scene.powerCycledAt(10.0).certain(), isAt(10.0)) << "the profile knows better";
}

// Story: an azimuth had coasted to 455.2° and its journal was lost. 95.2° was called certain: wrong by a full turn of
// the cable.
TEST(ReconcileOnlyPlace, CoastedBeyondTheTravelItIsNotSureOfAnotherTurn)
{
    Scene scene;
    scene.axis.travel = {-90_deg, 450_deg};
    scene.evidence.record.reset();
    EXPECT_THAT(inDegrees(scene.powerCycledAt(455.2).question().candidates), ElementsAre(95.2, 455.2));
    EXPECT_EQ(scene.question().proposed, std::nullopt);
}

}  // namespace
}  // namespace boresight::journal

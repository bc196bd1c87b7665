// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/course_anchor.h"

#include <gmock/gmock.h>

namespace boresight::journal {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr CourseAnchor kAnchor{.axis = Angle::fromDegrees(350.0),
                               .course = {.unbroken = 7, .azimuth = Angle::fromDegrees(28.0)}};

TurnQuestion question(std::optional<Angle> proposed)
{
    return {
        .candidates = {45_deg, 405_deg},
        .proposed = proposed,
        .evidence = {QStringLiteral("places"), QStringLiteral("journal"), QStringLiteral("The sensor reports 82.0°")},
        .period = 360_deg};
}

// REQ-MEMORY-09 (SensorCourse.*): A sensor on the antenna that ran without a gap since the wrap was known shows how far
// it has turned. This gives a sentence of evidence, and contradicts a proposal that is more than 30° away. It proposes
// and decides nothing.
TEST(SensorCourse, CountsWholeTurns)
{
    EXPECT_EQ(placeBySensor(kAnchor, SensorCourse{.unbroken = 7, .azimuth = 83_deg}), 405_deg);
    EXPECT_EQ(placeBySensor(kAnchor, SensorCourse{.unbroken = 7, .azimuth = -277_deg}), 45_deg);
}

TEST(SensorCourse, ABreakInBetweenSaysNothing)
{
    EXPECT_FALSE(placeBySensor(kAnchor, SensorCourse{.unbroken = 8, .azimuth = 83_deg}));
    EXPECT_FALSE(placeBySensor(kAnchor, std::nullopt));
    EXPECT_FALSE(placeBySensor(std::nullopt, kAnchor.course));
}

TEST(SensorCourse, AgreesWithAProposalInAnotherSentence)
{
    TurnQuestion asked = question(405_deg);
    addSensorTurning(asked, 398_deg);
    EXPECT_EQ(asked.proposed, 405_deg);
    ASSERT_EQ(asked.evidence.size(), 4U);
    EXPECT_THAT(asked.evidence[2].toStdString(), HasSubstr("It shows 398.0° (± 30.0°). This agrees"));
    EXPECT_EQ(asked.evidence.back(), QStringLiteral("The sensor reports 82.0°"));
}

TEST(SensorCourse, TakesBackAProposalThatItSpeaksAgainst)
{
    TurnQuestion asked = question(405_deg);
    addSensorTurning(asked, 50_deg);
    EXPECT_FALSE(asked.proposed) << "and none other in its place: it does not decide alone";
    EXPECT_THAT(asked.evidence[2].toStdString(), HasSubstr("This contradicts 405.0°, so Boresight proposes nothing."));
}

TEST(SensorCourse, ProposesNothingItself)
{
    TurnQuestion asked = question(std::nullopt);
    addSensorTurning(asked, 50_deg);
    EXPECT_FALSE(asked.proposed);
    EXPECT_THAT(asked.evidence[2].toStdString(), Not(HasSubstr("None of the possible places")));
    asked = question(std::nullopt);
    addSensorTurning(asked, 200_deg);
    EXPECT_THAT(asked.evidence[2].toStdString(), HasSubstr("None of the possible places is near this angle"));
}

}  // namespace
}  // namespace boresight::journal

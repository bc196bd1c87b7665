// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/identity_findings.h"

#include "tests/core/drive_check/finding_name.h"

#include <gmock/gmock.h>

namespace boresight::drive_check {
namespace {

using moteus::Register;
using testing::ElementsAre;
using testing::IsEmpty;

FoundController board(int id, std::uint32_t number, int map = 5)
{
    FoundController one{.id = id};
    const auto tell = [&](Register reg, double value) {
        one.known.values.push_back({reg, moteus::Resolution::Int32, value});
    };
    for (std::uint32_t word = 0; word < 3; ++word) {
        tell(Register::Uuid + word, 0.0);
    }
    tell(Register::Uuid + 3, number);
    tell(Register::FirmwareVersion, 0x010100);
    tell(Register::RegisterMapVersion, map);
    return one;
}

QString uuid(std::uint32_t number)
{
    return identityOf(board(1, number)).uuid;
}

std::vector<std::string> causesOf(const std::vector<FoundController>& found, const KnownBoards& known = {})
{
    std::vector<std::string> causes;
    for (const Finding& finding : identityFindings({}, known, found)) {
        causes.push_back(nameOf(finding));
        EXPECT_FALSE(finding.what.isEmpty() || finding.remedy.isEmpty()) << causes.back();
    }
    return causes;
}

// REQ-SURVEY-04 (Identity.*)
TEST(Identity, TheExpectedBoardsAreNoFinding)
{
    EXPECT_THAT(causesOf({board(1, 11), board(2, 12)}), IsEmpty());
    EXPECT_THAT(causesOf({board(1, 11), board(2, 12)}, {uuid(11), uuid(12)}), IsEmpty());
}

TEST(Identity, AThirdBoardIsAWarning)
{
    const auto findings = identityFindings({}, {}, std::vector{board(1, 11), board(2, 12), board(9, 13)});
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(nameOf(findings[0]), "drives.foreign-board.9");
    EXPECT_EQ(findings[0].weight, FindingWeight::Warning);
    EXPECT_TRUE(findings[0].what.contains(uuid(13)));
}

// REQ-SURVEY-04
TEST(Identity, AThirdBoardThatIsWatchedIsNoFinding)
{
    profile::Profile profile;
    profile.watchedBoards = {"9 polarisation"};
    EXPECT_THAT(identityFindings(profile, {}, std::vector{board(1, 11), board(2, 12), board(9, 13)}), IsEmpty());
    EXPECT_EQ(identityFindings(profile, {}, std::vector{board(1, 11), board(2, 12), board(8, 13)}).size(), 1u);
}

// If an axis has no drive, its id in the profile has no meaning. A board with this id is reported like any unknown
// board.
TEST(Identity, ABoardOfAnAxisWithoutDriveIsAsStrangeAsAny)
{
    const std::vector both{board(1, 11), board(2, 12)};
    const auto findings = identityFindings({}, {uuid(11), uuid(12)}, both, axesIf(true, false));
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(nameOf(findings[0]), "drives.foreign-board.2");
    EXPECT_EQ(findings[0].weight, FindingWeight::Warning);
    EXPECT_THAT(identityFindings({}, {}, std::vector{board(2, 12)}, axesIf(false, true)), IsEmpty());
    const auto swapped = identityFindings({}, {uuid(11), uuid(12)}, std::vector{board(1, 12)}, axesIf(true, false));
    ASSERT_EQ(swapped.size(), 1u);
    EXPECT_EQ(nameOf(swapped[0]), "drives.swapped") << "it turned the other axis when there was one";
}

TEST(Identity, TwoBoardsUnderOneIdBlockOnlyIfTheIdIsOurs)
{
    EXPECT_THAT(causesOf({board(1, 11), board(1, 13), board(2, 12)}), ElementsAre("drives.shared-id.1"));
    EXPECT_THAT(causesOf({FoundController{.id = 1}, board(2, 12)}), ElementsAre("drives.shared-id.1"))
        << "answers, but never whole";
    const auto unknownBoards =
        identityFindings({}, {}, std::vector{board(1, 11), board(2, 12), board(9, 13), board(9, 14)});
    ASSERT_EQ(unknownBoards.size(), 2u);
    EXPECT_EQ(nameOf(unknownBoards[0]), "drives.shared-id.9");
    EXPECT_EQ(unknownBoards[0].weight, FindingWeight::Warning);
}

TEST(Identity, SwappedIdsAreSaidOnce)
{
    EXPECT_THAT(causesOf({board(1, 12), board(2, 11)}, {uuid(11), uuid(12)}), ElementsAre("drives.swapped"));
    EXPECT_THAT(causesOf({board(1, 12), board(2, 13)}, {uuid(11), uuid(12)}),
                ElementsAre("drives.swapped", "drives.other.elevation"))
        << "the elevation's board drives the azimuth now, and a new one the elevation";
}

TEST(Identity, AnotherBoardThanBeforeIsAWarning)
{
    EXPECT_THAT(causesOf({board(1, 11), board(2, 14)}, {uuid(11), uuid(12)}), ElementsAre("drives.other.elevation"));
    EXPECT_THAT(causesOf({board(1, 11), board(2, 14)}, {uuid(11), QString()}), IsEmpty()) << "none was known";
}

TEST(Identity, AMapThatIsUnknownOrUntold)
{
    FoundController untold = board(2, 12);
    untold.known.values.pop_back();
    EXPECT_THAT(causesOf({board(1, 11, 4), untold}), ElementsAre("drives.map.azimuth", "drives.map.elevation"));
}

TEST(Identity, NobodyAtAllIsOneFinding)
{
    EXPECT_THAT(causesOf({}), ElementsAre("drives.none"));
    EXPECT_THAT(causesOf({board(1, 11)}), ElementsAre("drives.missing.elevation"));
}

}  // namespace
}  // namespace boresight::drive_check

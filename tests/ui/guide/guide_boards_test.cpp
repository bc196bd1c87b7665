// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_boards.h"

#include "tests/ui/guide/guide_fixture.h"
#include "ui/drives/protection_panel.h"
#include "ui/guide/bus_picture.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/step_picture.h"

#include <QListWidget>
#include <QPlainTextEdit>

// Boards with factory settings: both have the same id, and no gear ratio.
namespace boresight::ui {
namespace {

const QString kBoardUuid = QStringLiteral("626f7265-7369-6768-7420-73696d203032");

class GuideBoardsTest : public GuideTest
{
protected:
    GuideBoardsTest()
    {
        status.state = StationState::Disconnected;
        status.drives->driveCheck = DriveCheckState::NotDone;
        status.drives->armingObstacle = QStringLiteral("two boards have the id 1");
    }
    void showBoards(std::vector<BoardOnBus> boards)
    {
        status.drives->boards = std::move(boards);
        give(samples::update(status));
    }
};

// REQ-UI-970: The step Connect leads through the case of two boards with the same id. With only one board on the bus
// the operator says which axis it turns and confirms. The station does the rest and reports the result. No other tool
// is needed.
TEST_F(GuideBoardsTest, TwoBoardsWithOneIdAreExplained)
{
    open<GuideConnect>(GuideStep::Connect);
    status.permissions.refuse(Action::AssignAzimuthBoard, QStringLiteral("Two boards have the id 1."));
    status.permissions.refuse(Action::AssignElevationBoard, QStringLiteral("Two boards have the id 1."));
    showBoards({{.id = 1, .uuid = {}, .shared = true}});
    EXPECT_TRUE(inGuide<ValueLabel>("What to do with the boards").text().contains(QStringLiteral("Disconnect one")));
    EXPECT_FALSE(inGuide<QPushButton>("Assign to elevation …").isEnabled());
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::NeedsYou);
}

// REQ-UI-970
TEST_F(GuideBoardsTest, TheBoardThatIsAloneGetsItsIdAfterAConfirmation)
{
    open<GuideConnect>(GuideStep::Connect);
    status.permissions.refuse(Action::AssignAzimuthBoard, QStringLiteral("This board has the id 1 already."));
    showBoards({{.id = 1, .uuid = kBoardUuid}});
    EXPECT_FALSE(inGuide<QPushButton>("Assign to azimuth …").isEnabled()) << "it has this id";
    click("Assign to elevation …");
    EXPECT_TRUE(asked<request::AssignBoard>().empty()) << "it asks first";
    const auto* const question = guide().findChild<GuideBoards*>();
    ASSERT_TRUE(question->isAsking());
    bool named = false;
    for (const QPlainTextEdit* const text : question->findChildren<QPlainTextEdit*>()) {
        named = named || text->toPlainText().contains(kBoardUuid);
    }
    EXPECT_TRUE(named);
    // Story: the question was below the list of adapters, and its buttons were out of sight.
    EXPECT_FALSE(guide().findChild<QListWidget*>()->isVisible());
    const auto& write = inGuide<QPushButton>("Write");
    EXPECT_EQ(write.visibleRegion(), QRegion(write.rect()));
    click("Write");
    ASSERT_EQ(asked<request::AssignBoard>().size(), 1u);
    EXPECT_EQ(asked<request::AssignBoard>().front().board, kBoardUuid);
    EXPECT_EQ(asked<request::AssignBoard>().front().axis, Axis::Elevation);
    accept();

    status.drives->boardWork = {.running = true, .text = QStringLiteral("Reading back the id 2.")};
    give(samples::update(status));
    EXPECT_EQ(inGuide<ValueLabel>("What to do with the boards").text(), QStringLiteral("Reading back the id 2."));
    status.drives->boardWork = {.failed = true, .text = QStringLiteral("Nothing was stored.")};
    give(samples::update(status));
    EXPECT_EQ(inGuide<ValueLabel>("What to do with the boards").tone(), Tone::Warning);
    status.drives->boardWork = {.text = QStringLiteral("Connect the other board again.")};
    give(samples::update(status));
    EXPECT_EQ(inGuide<ValueLabel>("What to do with the boards").tone(), Tone::Normal);
    status = samples::freshMount();
    give(samples::update(status));
    EXPECT_FALSE(question->isVisible()) << "both are seen";
}

// REQ-UI-970
TEST_F(GuideBoardsTest, EscLeavesTheBoardAsItIs)
{
    open<GuideConnect>(GuideStep::Connect);
    showBoards({{.id = 1, .uuid = kBoardUuid}});
    click("Assign to elevation …");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(guide().findChild<GuideBoards*>()->isAsking());
    EXPECT_TRUE(asked<request::AssignBoard>().empty());
}

// REQ-UI-971: A gear ratio that differs from the profile is set from the page Protect, after a text about the other
// settings that depend on it.
TEST_F(GuideBoardsTest, AWrongGearIsSetFromThePageProtect)
{
    status = samples::factoryDrives();
    give(samples::update(status));
    open<ProtectionPanel>(GuideStep::Protection);
    EXPECT_EQ(findNamed<QPushButton>(*guide().findChild<ProtectionPanel*>(), "Set gear …")->isVisible(), false);
    status.drives->elevation.gear = GearCorrection{.found = QStringLiteral("1"),
                                                   .wanted = QStringLiteral("0.01"),
                                                   .effect = QStringLiteral("The gains keep their numbers.")};
    status.permissions = Permissions::all();
    give(samples::update(status));
    click("Set gear …");
    EXPECT_TRUE(asked<request::SetGear>().empty()) << "it asks first";
    bool told = false;
    for (const QPlainTextEdit* const text : guide().findChildren<QPlainTextEdit*>()) {
        told = told || (text->isVisible() && text->toPlainText().contains(QStringLiteral("gains keep their numbers")));
    }
    EXPECT_TRUE(told);
    click("Write");
    ASSERT_EQ(asked<request::SetGear>().size(), 1u);
    EXPECT_EQ(asked<request::SetGear>().front().axis, Axis::Elevation);
}

// REQ-UI-972: Steps that need manual work have a picture, which a screen reader describes.
TEST_F(GuideTest, StepsThatNeedHandsHaveAPicture)
{
    for (const GuideStep step : {GuideStep::Travel, GuideStep::Level, GuideStep::North}) {
        open<QWidget>(step);
        EXPECT_FALSE(inGuide<StepPicture>("Picture of this step").accessibleDescription().isEmpty());
    }
    open<QWidget>(GuideStep::Connect);
    EXPECT_TRUE(
        inGuide<BusPicture>("Cabling of adapter and drives").accessibleDescription().contains(QStringLiteral("120 Ω")));
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/box_console_panel.h"

#include "tests/ui/drives/drives_fixture.h"
#include "tests/ui/sample_permissions.h"
#include "ui/kit/page_room.h"
#include "ui/kit/value_label.h"

#include <QLineEdit>

namespace boresight::ui {
namespace {

StationStatus withConsole(const QStringList& lines)
{
    StationStatus status = samples::idle();
    status.console = lines;
    return status;
}

// REQ-UI-1721: A mount with a control box has a panel to type a line to the box, which shows the answers. A mount
// without one has no such panel.
TEST_F(DrivesTest, ALineIsTypedToTheControlBox)
{
    const QTabWidget& mount = *named<QTabWidget>("The mount itself");
    auto* const panel = window.findChild<BoxConsolePanel*>();
    EXPECT_FALSE(mount.isTabVisible(tabOf(mount, *panel)));
    give(samples::update(withConsole({})));
    EXPECT_TRUE(mount.isTabVisible(tabOf(mount, *panel)));
    open<BoxConsolePanel>();

    auto* const line = named<QLineEdit>("Line for the control box");
    line->setFocus();
    QTest::keyClicks(line, QStringLiteral("CALSTATS"));
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_EQ(asked<request::TypeLine>().size(), 1U);
    EXPECT_EQ(asked<request::TypeLine>().front().line, "CALSTATS");
    give(samples::refusal(withConsole({}), requests.back().id, "The mount moves."));
    EXPECT_EQ(line->text(), QStringLiteral("CALSTATS")) << "a refusal keeps the line";
    click("Send line");
    give(samples::acceptance(withConsole({QStringLiteral("> CALSTATS"), QStringLiteral("Accel Rad: 1000")}),
                             requests.back().id));
    EXPECT_EQ(line->text(), QString());
    EXPECT_EQ(named<QPlainTextEdit>("Answers of the control box")->toPlainText(),
              QStringLiteral("> CALSTATS\nAccel Rad: 1000"));

    StationStatus moving = withConsole({});
    moving.permissions.refuse(Action::TypeLine, QStringLiteral("The mount moves. Stop it first."));
    give(samples::update(moving));
    expectBlocked("Send line", "The mount moves. Stop it first.");
    QTest::keyClicks(line, QStringLiteral("C2"));
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(asked<request::TypeLine>().size(), 2U);
}

// REQ-UI-1753: A rotator that makes home runs has a button for it, which asks first. A rotator without that command has
// no such button.
TEST_F(DrivesTest, AHomeRunIsAskedFor)
{
    StationStatus status = samples::idle();
    status.capabilities.makesHomeRuns = true;
    give(samples::update(status));
    open<BoxConsolePanel>();
    EXPECT_FALSE(named<QLineEdit>("Line for the control box")->isVisible()) << "this rotator has no console";
    click("Home run …");
    EXPECT_TRUE(questionText().contains(QLatin1String("limits")));
    EXPECT_TRUE(asked<request::MakeHomeRun>().empty());
    QTest::mouseClick(act("Make the home run"), Qt::LeftButton);
    EXPECT_EQ(asked<request::MakeHomeRun>().size(), 1U);
    status.console = QStringList();
    status.capabilities.makesHomeRuns = false;
    give(samples::acceptance(status, requests.back().id));
    EXPECT_FALSE(named<CommandButton>("Home run …")->isVisible());
    EXPECT_TRUE(named<QLineEdit>("Line for the control box")->isVisible());
}

// REQ-UI-1752: The panel of a control box shows the offsets that its sensor reports, and those of the profile if they
// differ. One press saves them with the profile. A box that reports none has no such row.
TEST_F(DrivesTest, TheSensorOffsetsOfABoxAreSaved)
{
    StationStatus status = withConsole({});
    give(samples::update(status));
    open<BoxConsolePanel>();
    EXPECT_FALSE(named<CommandButton>("Save offsets")->isVisible());
    status.line.sensorOffsets = "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1000 700";
    give(samples::update(status));
    EXPECT_TRUE(named<CommandButton>("Save offsets")->isVisible());
    EXPECT_TRUE(named<ValueLabel>("Sensor offsets of the control box")->text().contains(QLatin1String("not saved")));
    click("Save offsets");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1U);
    EXPECT_EQ(asked<request::ApplyProfile>().front().profile.rotator.sensorOffsets, status.line.sensorOffsets);
}

}  // namespace
}  // namespace boresight::ui

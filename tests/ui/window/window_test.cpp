// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/close_prompt.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

namespace boresight::ui {
namespace {

using std::chrono::milliseconds;

class WindowTest : public WindowFixture
{
protected:
    QPushButton* buttonSaying(const char* text)
    {
        for (QPushButton* const button : window.findChildren<QPushButton*>()) {
            if (button->text() == QLatin1String(text) && button->isVisible()) {
                return button;
            }
        }
        ADD_FAILURE() << "no visible button " << text;
        return nullptr;
    }
    bool somethingSays(const char* words)
    {
        for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
            if (label->isVisible() && label->text() == QString::fromUtf8(words)) {
                return true;
            }
        }
        return false;
    }
};

TEST_F(WindowTest, ShowsStateTargetSourceLinksAndTime)
{
    give(samples::update(samples::operatorMoving()));
    EXPECT_EQ(text("Station state"), QStringLiteral("SLEW"));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Go to 113.0° 10.0°, there in 6 s, by operator"));
    EXPECT_EQ(text("Who has control"), QStringLiteral("Control: you"));
    EXPECT_EQ(text("UTC"), QStringLiteral("17:06:19Z"));
    EXPECT_EQ(text("Simulated mount"), QStringLiteral("SIMULATED"));
    EXPECT_EQ(text("Actual azimuth"), QStringLiteral("62.00°"));
    EXPECT_EQ(text("Target azimuth"), QStringLiteral("113.00°"));
    EXPECT_EQ(text("Error of azimuth"), QStringLiteral("+51.00°"));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("MOVING"));
    give(samples::update(samples::disconnected()));
    EXPECT_EQ(text("Simulated mount"), QString());
    EXPECT_EQ(named<ValueLabel>("Line to the mount")->symbol(), Symbol::Alarm);
}

// Story: a window of 1024×700 was 1285 px wide after F11 and F11. The charts of the full screen kept it wide.
// REQ-UI-1791: A wide window becomes narrow at once, as after full screen. The charts beside the panels do not keep it
// wide.
TEST_F(WindowTest, AWideWindowBecomesNarrowAtOnce)
{
    window.resize(1920, 1080);
    settle();
    window.resize(1024, 700);
    settle();
    EXPECT_EQ(window.size(), QSize(1024, 700));
}

// Story: an armed schedule moves the mount by itself, and only the page of the schedule showed that it was armed.
// REQ-UI-1495: While the schedule is armed and the mount stands still, the header says so, with the next pass and the
// time until then.
TEST_F(WindowTest, TheHeaderSaysThatTheScheduleIsArmed)
{
    StationStatus status = samples::idle();
    ScheduleStatus schedule{.armed = true};
    status.schedule = std::make_shared<const ScheduleStatus>(schedule);
    give(samples::update(status));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Schedule armed"));
    passes::Pass pass;
    pass.aos.utc = status.utc + std::chrono::minutes(97);
    pass.los.utc = pass.aos.utc + std::chrono::minutes(10);
    schedule.plan.chosen = {{.number = 25544, .name = QStringLiteral("ISS"), .pass = pass}};
    status.schedule = std::make_shared<const ScheduleStatus>(schedule);
    give(samples::update(status));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Schedule armed: ISS in 97 min"));
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS")};
    status.targetText = QStringLiteral("track ISS");
    give(samples::update(status));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Tracking ISS"));
    status.tracked.reset();
    status.state = StationState::Slew;
    status.targetText = QStringLiteral("park");
    give(samples::update(status));
    EXPECT_FALSE(text("Target and its source").contains(QStringLiteral("armed"))) << "it moves";
    status.state = StationState::Hold;
    schedule.armed = false;
    status.schedule = std::make_shared<const ScheduleStatus>(schedule);
    status.targetText.clear();
    give(samples::update(status));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("no target"));
}

TEST_F(WindowTest, TheClientListIsInTheTooltip)
{
    give(samples::update(samples::withClients(samples::tracking(1), 3)));
    const QString help = named<ValueLabel>("Who has control")->toolTip();
    EXPECT_TRUE(help.contains(QLatin1String("listens on 127.0.0.1:4533")));
    EXPECT_TRUE(help.contains(QLatin1String("127.0.0.1:51236")));
    EXPECT_TRUE(help.contains(QLatin1String("Gpredict")));
}

TEST_F(WindowTest, TheErrorFollowsTheWayTheAxisGoes)
{
    StationStatus status = samples::tracking(1);
    status.azimuth.actual = 350_deg;
    status.azimuth.target = 370_deg;  // through north
    give(samples::update(status));
    EXPECT_EQ(text("Target azimuth"), QStringLiteral("10.00°"));
    EXPECT_EQ(text("Error of azimuth"), QStringLiteral("+20.00°"));
}

// REQ-UI-04
TEST_F(WindowTest, OldNumbersAreDimmedWithTheirAgeThenNotShown)
{
    const StationStatus status = samples::tracking(100);
    give(samples::update(status));
    const QString live = text("Actual azimuth");
    EXPECT_EQ(named<ValueLabel>("Actual azimuth")->tone(), Tone::Normal);

    give(samples::update(samples::withAge(status, milliseconds(700))));
    EXPECT_EQ(text("Actual azimuth"), live);
    EXPECT_EQ(named<ValueLabel>("Actual azimuth")->tone(), Tone::Secondary);
    EXPECT_EQ(text("Detail of azimuth"), QStringLiteral("age 0.7 s"));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("MOVING"));

    give(samples::update(samples::withAge(status, milliseconds(2000))));
    EXPECT_EQ(text("Actual azimuth"), QStringLiteral("---.--°"));
    EXPECT_EQ(text("Error of azimuth"), QStringLiteral("---.--°"));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("NO DATA"));
}

// The station thread itself may hang: then no status reports that the numbers are old.
// REQ-UI-04
TEST_F(WindowTest, ASilentStationAgesTheScreenByItself)
{
    give(samples::update(samples::tracking(100)));
    elapse(Seconds(1.0));
    EXPECT_EQ(text("Detail of azimuth"), QStringLiteral("age 1.0 s"));
    elapse(Seconds(1.5));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("NO DATA"));
    EXPECT_TRUE(text("Worst alarm").contains(QLatin1String("The station has sent no status for 2.5 s")));
    give(samples::update(samples::tracking(100)));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("MOVING"));
    EXPECT_FALSE(named<ValueLabel>("Worst alarm")->isVisible());
}

TEST_F(WindowTest, EachUpdateIsCredited)
{
    QSignalSpy shown(&window, &MainWindow::updateShown);
    give(samples::update(samples::idle()));
    give(samples::update(samples::idle()));
    EXPECT_EQ(shown.count(), 2);
}

TEST_F(WindowTest, GoToByKeyboardAlone)
{
    QTest::keyClick(&window, Qt::Key_G, Qt::ControlModifier);
    auto* const azimuth = named<QLineEdit>("Azimuth");
    ASSERT_TRUE(azimuth->hasFocus());
    QTest::keyClicks(azimuth, QStringLiteral("113.5"));
    EXPECT_TRUE(requests.empty()) << "typing moves nothing";
    auto* const elevation = named<QLineEdit>("Elevation");
    elevation->setFocus();
    QTest::keyClicks(elevation, QStringLiteral("10"));
    QTest::keyClick(elevation, Qt::Key_Return);
    ASSERT_EQ(asked<request::PointSky>().size(), 1u);
    EXPECT_NEAR(asked<request::PointSky>().front().direction.azimuth.degrees(), 113.5, 1e-9);
    EXPECT_NEAR(asked<request::PointSky>().front().direction.elevation.degrees(), 10.0, 1e-9);
}

// REQ-UI-05: A pressed control shows "requested" until the answer. A refusal is shown next to it, and the typed value
// stays.
TEST_F(WindowTest, ARefusedGoToKeepsTheValueAndShowsTheReason)
{
    named<QLineEdit>("Azimuth")->setText(QStringLiteral("10"));
    named<QLineEdit>("Elevation")->setText(QStringLiteral("95"));
    auto* const go = named<CommandButton>("Go");
    QTest::mouseClick(go, Qt::LeftButton);
    EXPECT_TRUE(go->isWaiting());
    EXPECT_TRUE(go->text().contains(QLatin1String("requested")));
    give(samples::refusal(samples::idle(), requests.back().id, "elevation 95.0° above limit 90.0°"));
    EXPECT_FALSE(go->isWaiting());
    EXPECT_TRUE(somethingSays("Go: elevation 95.0° above limit 90.0°"));
    EXPECT_EQ(named<QLineEdit>("Elevation")->text(), QStringLiteral("95"));

    QTest::mouseClick(go, Qt::LeftButton);
    give(samples::acceptance(samples::operatorMoving(), requests.back().id));
    EXPECT_FALSE(somethingSays("Go: elevation 95.0° above limit 90.0°"));
}

// REQ-UI-07
TEST_F(WindowTest, AnUnreadableNumberIsNotSent)
{
    for (const char* const bad : {"abc", "1,5", "nan", "1e999"}) {
        named<QLineEdit>("Azimuth")->setText(QLatin1String(bad));
        named<QLineEdit>("Elevation")->setText(QStringLiteral("10"));
        QTest::mouseClick(named<CommandButton>("Go"), Qt::LeftButton);
        EXPECT_EQ(named<QLineEdit>("Azimuth")->text(), QLatin1String(bad));
    }
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(somethingSays("Go: The azimuth is not a number. Type it with a decimal point, for example 113.5."));
}

TEST_F(WindowTest, ParkHomeAndHoldHaveTheirRequests)
{
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(somethingSays("Park: The mount is already parked."));
    StationStatus holding = samples::idle();
    holding.state = StationState::Hold;
    give(samples::update(holding));
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    EXPECT_EQ(asked<request::Park>().size(), 1u);
    QTest::keyClick(&window, Qt::Key_H, Qt::ControlModifier);
    EXPECT_EQ(asked<request::Hold>().size(), 1u);
    QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    QTest::mouseClick(named<CommandButton>("Home"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Home>().size(), 1u);
    give(samples::update(samples::stopped()));
    requests.clear();
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    EXPECT_TRUE(requests.empty());
}

// REQ-UI-07: A motion begins only by an explicit act. Typing, letters and a click on the plot move nothing.
TEST_F(WindowTest, LettersAloneNeverMoveTheAntenna)
{
    for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key) {
        QTest::keyClick(&window, static_cast<Qt::Key>(key));
    }
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Return, Qt::Key_Space}) {
        QTest::keyClick(&window, key);
    }
    EXPECT_TRUE(requests.empty());
}

// REQ-UI-07
TEST_F(WindowTest, AClickOnThePlotOffersGoHereAsASecondAct)
{
    auto* const plot = window.findChild<PolarPlot*>();
    auto* const sky = plot->findChild<SkyMarkers*>();
    QTest::mouseClick(sky, Qt::LeftButton, {}, sky->projection().toPixel({90_deg, 45_deg}).toPoint());
    EXPECT_TRUE(requests.empty());
    auto* const goHere = named<CommandButton>("Go here");
    ASSERT_TRUE(goHere->isVisible());
    QTest::mouseClick(goHere, Qt::LeftButton);
    ASSERT_EQ(asked<request::PointSky>().size(), 1u);
    EXPECT_NEAR(asked<request::PointSky>().front().direction.azimuth.degrees(), 90.0, 0.5);
    give(samples::refusal(samples::idle(), requests.back().id, "masked by the mast"));
    EXPECT_TRUE(goHere->isVisible());
    EXPECT_TRUE(somethingSays("Go here: masked by the mast"));
    QTest::mouseClick(goHere, Qt::LeftButton);
    give(samples::acceptance(samples::operatorMoving(), requests.back().id));
    EXPECT_FALSE(goHere->isVisible());
}

TEST_F(WindowTest, AlarmsAreShownAcknowledgedAndFaultsReArmed)
{
    window.resize(1920, 1080);  // with room for one line for each sentence
    QCoreApplication::processEvents();
    give(samples::update(samples::faulted()));
    EXPECT_TRUE(text("Worst alarm").contains(QLatin1String("fault 38")));
    EXPECT_EQ(named<QPushButton>("All alarms")->text(), QStringLiteral("1 of 2"));
    EXPECT_TRUE(text("What was done and what to do").startsWith(QLatin1String("The drive switched its output off")));
    QTest::keyClick(&window, Qt::Key_F8);
    EXPECT_EQ(asked<request::AcknowledgeAlarms>().size(), 1u);
    QTest::mouseClick(named<CommandButton>("Re-arm"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Rearm>().size(), 1u);
    EXPECT_TRUE(asked<request::ResetStop>().empty());
    StationStatus calm = samples::faulted();
    for (Alarm& alarm : calm.alarms) {
        alarm.acknowledged = true;
    }
    give(samples::acceptance(calm, requests.front().id));
    EXPECT_FALSE(named<CommandButton>("Acknowledge")->isVisible());
}

TEST_F(WindowTest, TheListOfAlarmsSaysWhichAreOver)
{
    StationStatus status = samples::faulted();
    status.alarms.back().active = false;
    give(samples::update(status));
    const QString list = named<ValueLabel>("Worst alarm")->toolTip();
    EXPECT_EQ(list.count(QStringLiteral(", cleared\n")), 1) << list.toStdString();
    EXPECT_GT(list.indexOf(QStringLiteral(", cleared")), list.indexOf(QStringLiteral("fault 38")));
}

// REQ-UI-05
TEST_F(WindowTest, AnOldRefusalNextToAnotherControlStaysThere)
{
    StationStatus holding = samples::idle();
    holding.state = StationState::Hold;
    give(samples::update(holding));
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    QTest::mouseClick(named<CommandButton>("Take control"), Qt::LeftButton);
    StationUpdate both = samples::refusal(samples::idle(), requests[0].id, "no park position");
    both.answers.push_back({requests[1].id, std::nullopt});
    give(both);
    EXPECT_TRUE(somethingSays("Park: no park position"));
}

TEST_F(WindowTest, ControlGoesBackToTheClientsWithOneClick)
{
    QTest::mouseClick(named<CommandButton>("Take control"), Qt::LeftButton);
    EXPECT_EQ(asked<request::TakeAuthority>().size(), 1u);
    give(samples::acceptance(samples::operatorMoving(), requests.back().id));
    QTest::mouseClick(named<CommandButton>("Hand over"), Qt::LeftButton);
    EXPECT_EQ(asked<request::GiveAuthority>().size(), 1u);
}

TEST_F(WindowTest, ATargetOutsideTheLimitsIsToldWithTheReason)
{
    give(samples::update(samples::limited()));
    EXPECT_EQ(text("Target limited"), QStringLiteral("AT LIMIT"));
    EXPECT_TRUE(
        named<ValueLabel>("Target limited")->toolTip().endsWith(QStringLiteral("elevation -2.4° below limit 10.0°")));
    EXPECT_TRUE(text("Worst alarm").contains(QStringLiteral("outside the limits")));
    EXPECT_TRUE(
        named<ValueLabel>("Worst alarm")->toolTip().contains(QStringLiteral("elevation -2.4° below limit 10.0°")));
    EXPECT_FALSE(named<ValueLabel>("What was done and what to do")->toolTip().isEmpty());
    give(samples::update(samples::idle()));
    EXPECT_FALSE(named<ValueLabel>("Worst alarm")->isVisible());
    EXPECT_EQ(named<ValueLabel>("Worst alarm")->toolTip(), QString());
}

// REQ-UI-09: Closing asks once, only while the mount moves.
TEST_F(WindowTest, ClosingAsksOnceOnlyWhileTheMountMoves)
{
    QSignalSpy close(&window, &MainWindow::closeRequested);
    give(samples::update(samples::tracking(10)));
    window.close();
    window.close();
    EXPECT_TRUE(window.isVisible());
    EXPECT_EQ(close.count(), 0);
    QTest::mouseClick(buttonSaying("Keep open"), Qt::LeftButton);
    EXPECT_EQ(close.count(), 0);
    window.close();
    EXPECT_TRUE(window.findChild<ClosePrompt*>()->isVisible());
    // Story: after Esc the question stayed, and a further closing had no effect
    give(samples::update(samples::idle()));
    EXPECT_FALSE(window.findChild<ClosePrompt*>()->isVisible()) << "it stands";
    give(samples::update(samples::tracking(11)));
    window.close();
    QTest::mouseClick(buttonSaying("Stop and close"), Qt::LeftButton);
    EXPECT_EQ(close.count(), 1);
    EXPECT_TRUE(window.isVisible()) << "the owner closes it when the mount stands";
    window.closeNow();
    EXPECT_FALSE(window.isVisible());
}

// REQ-UI-33: The chosen panels and charts are restored at the next start. A magnified plot is not.
TEST_F(WindowTest, TheChosenPanelsAndChartsAreRemembered)
{
    openPanel('2');
    QTest::mouseClick(named<QAbstractButton>("Charts of the elevation"), Qt::LeftButton);
    QTest::mouseClick(named<QAbstractButton>("Show the last 5 min"), Qt::LeftButton);
    named<QComboBox>("Quantity of the drive")->setCurrentIndex(2);
    openPanel('7');
    openPanel('3');
    WindowSettings next = settings();
    next.layout = window.arrangement();
    const MainWindow again(clock, next);
    EXPECT_EQ(again.arrangement().panel, 3);
    EXPECT_EQ(again.arrangement().mountPanel, 7);
    EXPECT_EQ(again.arrangement().charts.axis, Axis::Elevation);
    EXPECT_EQ(again.arrangement().charts.window, std::chrono::seconds(300));
    EXPECT_EQ(again.arrangement().charts.quantity, DriveQuantity::Voltage);

    openPanel('8');
    next.layout = window.arrangement();
    EXPECT_EQ(next.layout.panel, 8) << "a panel within Mount";
    next.layout.panel = 77;  // from a file that was edited by hand
    next.layout.charts.window = std::chrono::seconds(7);
    const MainWindow wrong(clock, next);
    EXPECT_EQ(wrong.arrangement().panel, 8) << "that of Mount was brought up";
    EXPECT_EQ(wrong.arrangement().charts.window, std::chrono::seconds(60));
}

// REQ-UI-09
TEST_F(WindowTest, ClosingAStandingMountDoesNotAsk)
{
    QSignalSpy close(&window, &MainWindow::closeRequested);
    window.close();
    EXPECT_EQ(close.count(), 1);
}

}  // namespace
}  // namespace boresight::ui

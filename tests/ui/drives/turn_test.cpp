// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_permissions.h"
#include "tests/ui/window_fixture.h"
#include "ui/drives/turn_choice.h"
#include "ui/drives/turn_page.h"
#include "ui/hold/jog_pad.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/page_room.h"
#include "ui/sky/sky_markers.h"
#include "ui/window/stop_button.h"

#include <QAbstractSlider>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QTabWidget>

namespace boresight::ui {
namespace {

StationStatus fewPlaces(bool proposed = true)
{
    return samples::asking(Axis::Azimuth, 3, 180_deg, proposed);
}

StationStatus manyTurns()
{
    return samples::asking(Axis::Azimuth, 150, 3.6_deg, false);
}

class TurnTest : public WindowFixture
{
protected:
    QTabWidget& panels() { return *window.findChild<QTabWidget*>(); }
    TurnPage& page() { return *window.findChild<TurnPage*>(); }
    CommandButton& answer() { return *named<CommandButton>("Confirm position"); }
    QLineEdit& field() { return *named<QLineEdit>("Angle read off the mount"); }
    bool answerable()  // not at once
    {
        const bool atOnce = answer().isEnabled();
        elapse(Seconds(0.8));
        return !atOnce && answer().isEnabled();
    }
    QRadioButton* place(const char* angle)
    {
        for (QRadioButton* const button : page().findChildren<QRadioButton*>()) {
            if (button->isVisible() && button->text() == QString::fromUtf8(angle)) {
                return button;
            }
        }
        ADD_FAILURE() << "no place " << angle;
        return nullptr;
    }
    void expectAnswered(Axis axis, double degrees)
    {
        ASSERT_EQ(asked<request::ChooseTurn>().size(), 1u);
        EXPECT_EQ(asked<request::ChooseTurn>().front().axis, axis);
        EXPECT_NEAR(asked<request::ChooseTurn>().front().angle.degrees(), degrees, 1e-9);
    }
};

// REQ-UI-14: The question about a wrap opens once, covers nothing, preselects only what is proposed, and one press
// answers for one axis.
TEST_F(TurnTest, OpensByItselfOnceAndWaitsBehindItsTab)
{
    EXPECT_FALSE(panels().isTabVisible(tabOf(panels(), page())));
    give(samples::update(fewPlaces()));
    EXPECT_EQ(shownPage(panels()), &page());
    openPanel('1');
    give(samples::update(fewPlaces()));
    EXPECT_EQ(panels().currentIndex(), 0) << "it does not come back by itself";
    openPanel('9');
    EXPECT_EQ(shownPage(panels()), &page());
    give(samples::update(samples::idle()));
    EXPECT_EQ(panels().currentIndex(), 0);
    EXPECT_FALSE(panels().isTabVisible(tabOf(panels(), page())));
}

// REQ-UI-14
TEST_F(TurnTest, CoversNeitherStopNorStateNorAlarmsAndStopWorks)
{
    give(samples::update(fewPlaces()));
    auto* const stop = window.findChild<StopButton*>();
    EXPECT_EQ(window.size(), QSize(1024, 700));
    for (const QWidget* const above :
         {static_cast<QWidget*>(stop), static_cast<QWidget*>(named<ValueLabel>("Actual azimuth"))}) {
        EXPECT_EQ(window.childAt(above->mapTo(&window, above->rect().center())), above);
    }
    QTest::mousePress(stop, Qt::LeftButton);
    QTest::keyClick(&window, Qt::Key_F12);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(asked<request::Stop>().size(), 3u);
}

// REQ-UI-14
TEST_F(TurnTest, TheProposedPlaceIsSelectedAndOnePressAnswers)
{
    give(samples::update(fewPlaces()));
    EXPECT_TRUE(place("45.1°")->isChecked());
    const QString evidence = named<QPlainTextEdit>("Evidence")->toPlainText();
    EXPECT_TRUE(evidence.startsWith(QStringLiteral("• The angle is known only to a multiple of 180.0°")));
    EXPECT_TRUE(evidence.contains(QStringLiteral("Boresight proposes 45.1°")));
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    expectAnswered(Axis::Azimuth, 45.1);
}

// REQ-UI-14
TEST_F(TurnTest, WithoutAProposalNothingIsSelectedAndNothingCanBeSent)
{
    give(samples::update(fewPlaces(false)));
    for (const QRadioButton* const button : page().findChildren<QRadioButton*>()) {
        EXPECT_FALSE(button->isChecked());
    }
    EXPECT_FALSE(answer().isEnabled());
    EXPECT_TRUE(answer().toolTip().contains(QLatin1String("first select the position of the axis")));
    QTest::mouseClick(place("225.1°"), Qt::LeftButton, {}, QPoint(10, 20));
    EXPECT_TRUE(place("225.1°")->isChecked());
    ASSERT_TRUE(answerable());
    EXPECT_TRUE(requests.empty()) << "selecting sends nothing";
    answer().setFocus();
    QTest::keyClick(&answer(), Qt::Key_Space);
    expectAnswered(Axis::Azimuth, 225.1);
}

TEST_F(TurnTest, ArrowKeysChooseAmongTheFewPlaces)
{
    give(samples::update(fewPlaces()));
    place("45.1°")->setFocus();
    QTest::keyClick(place("45.1°"), Qt::Key_Right);
    EXPECT_TRUE(place("225.1°")->isChecked());
    give(samples::update(fewPlaces()));
    EXPECT_TRUE(place("225.1°")->isChecked()) << "the next status does not take it back";
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    expectAnswered(Axis::Azimuth, 225.1);
}

TEST_F(TurnTest, AmongManyPlacesAnAngleSelectsTheNearest)
{
    give(samples::update(manyTurns()));
    EXPECT_EQ(text("Selected place"), QStringLiteral("nothing selected"));
    field().setFocus();
    QTest::keyClicks(&field(), QStringLiteral("-30"));
    EXPECT_EQ(text("Selected place"), QStringLiteral("selects -30.5°, place 17 of 150"));
    QTest::keyClicks(&field(), QStringLiteral("x"));
    EXPECT_EQ(text("Selected place"), QStringLiteral("nothing selected"));
    EXPECT_FALSE(answer().isEnabled());
    QTest::keyClick(&field(), Qt::Key_Backspace);
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    expectAnswered(Axis::Azimuth, -30.5);
}

// Story: -30° was entered, and -14.2° was sent without a report.
TEST_F(TurnTest, AnAngleFarFromAllPlacesSelectsNone)
{
    give(samples::update(manyTurns()));
    field().setFocus();
    QTest::keyClicks(&field(), QStringLiteral("-120"));
    EXPECT_EQ(text("Selected place"), QStringLiteral("nothing selected"));
    EXPECT_FALSE(answer().isEnabled());
}

// REQ-UI-1411: When a field for the axis angle receives the focus, by key or by click, its text is selected, so that
// typing replaces it.
TEST_F(TurnTest, WhatIsTypedReplacesTheAngleThatStandsInTheField)
{
    give(samples::update(samples::asking(Axis::Azimuth, 150, 3.6_deg, true)));
    ASSERT_FALSE(field().text().isEmpty());
    answer().setFocus();
    QTest::mouseClick(&field(), Qt::LeftButton);
    QCoreApplication::processEvents();
    EXPECT_EQ(field().selectedText(), field().text());
    QTest::keyClicks(&field(), QStringLiteral("120"));
    EXPECT_EQ(field().text(), QStringLiteral("120"));
}

TEST_F(TurnTest, WithoutPlacesTheAngleItselfIsTheAnswer)
{
    give(samples::update(samples::asking(Axis::Elevation, 0, 0_deg, false)));
    EXPECT_FALSE(answer().isEnabled());
    field().setFocus();
    QTest::keyClicks(&field(), QStringLiteral("12.5"));
    EXPECT_EQ(text("Selected place"), QStringLiteral("stands at 12.5°"));
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    expectAnswered(Axis::Elevation, 12.5);
}

// The second press of a double click must not answer for the other axis.
// REQ-UI-14
TEST_F(TurnTest, AxesAreAskedOneAfterTheOtherAndADoubleClickAnswersOnlyOne)
{
    StationStatus both = samples::asking(Axis::Elevation, 3, 30_deg, true);
    both.drives->azimuth = fewPlaces().drives->azimuth;
    both.azimuth.turnKnown = false;
    give(samples::update(both));
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    expectAnswered(Axis::Azimuth, 45.1);
    give(samples::acceptance(samples::asking(Axis::Elevation, 3, 30_deg, true), requests.back().id));
    QTest::mouseClick(&answer(), Qt::LeftButton);
    EXPECT_EQ(asked<request::ChooseTurn>().size(), 1u);
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    ASSERT_EQ(asked<request::ChooseTurn>().size(), 2u);
    EXPECT_EQ(asked<request::ChooseTurn>().back().axis, Axis::Elevation);
}

TEST_F(TurnTest, ARefusalStandsBelowTheButton)
{
    give(samples::update(fewPlaces()));
    ASSERT_TRUE(answerable());
    QTest::mouseClick(&answer(), Qt::LeftButton);
    give(samples::refusal(fewPlaces(), requests.back().id, "45.1° is outside the travel"));
    EXPECT_TRUE(place("45.1°")->isChecked());
    bool shown = false;
    for (const ValueLabel* const label : page().findChildren<ValueLabel*>()) {
        shown = shown || (label->isVisible() && label->text().endsWith(QStringLiteral("45.1° is outside the travel")));
    }
    EXPECT_TRUE(shown);
}

TEST_F(TurnTest, UnwindingIsADeadManAtItsOwnRate)
{
    give(samples::update(fewPlaces()));
    auto* const back = named<QPushButton>("Turn counter-clockwise at 2.0°/s while held");
    QTest::mousePress(back, Qt::LeftButton);
    elapse(3 * kJogRepeat);
    ASSERT_EQ(asked<request::Jog>().size(), 4u);
    EXPECT_EQ(asked<request::Jog>().back().rates, (AxisRates{-2_deg_s, 0_deg_s}));
    QTest::mouseRelease(back, Qt::LeftButton);
    EXPECT_EQ(asked<request::Jog>().back().rates, AxisRates{});
    EXPECT_FALSE(named<QPushButton>("Raise at 2.0°/s while held")->isVisible());

    give(samples::update(samples::asking(Axis::Elevation, 3, 30_deg, false)));
    QTest::mousePress(named<QPushButton>("Raise at 2.0°/s while held"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Jog>().back().rates, (AxisRates{0_deg_s, 2_deg_s}));
    openPanel('1');
    EXPECT_EQ(asked<request::Jog>().back().rates, AxisRates{}) << "leaving the page lets go";
}

// Story: the rate was lowered while the program ran. These buttons kept the rate of the start, and every press was
// refused.
TEST_F(TurnTest, UnwindingIsAsFastAsTheProfileSaysNow)
{
    give(samples::update(fewPlaces()));
    StationStatus slower = fewPlaces();
    profile::Profile changed = *slower.profile;
    changed.jog.unwind = 0.5_deg_s;
    slower.profile = std::make_shared<const profile::Profile>(changed);
    give(samples::update(slower));
    auto* const back = named<QPushButton>("Turn counter-clockwise at 0.5°/s while held");
    ASSERT_NE(back, nullptr);
    QTest::mousePress(back, Qt::LeftButton);
    EXPECT_EQ(asked<request::Jog>().back().rates, (AxisRates{-0.5_deg_s, 0_deg_s}));
    QTest::mouseRelease(back, Qt::LeftButton);
}

TEST_F(TurnTest, UnwindingEndsWithThePermissionAndWithARefusal)
{
    give(samples::update(fewPlaces()));
    auto* const forth = named<QPushButton>("Turn clockwise at 2.0°/s while held");
    QTest::mousePress(forth, Qt::LeftButton);
    StationStatus stopped = fewPlaces();
    stopped.permissions = samples::withoutMotion(QStringLiteral("STOP is latched. Reset STOP first."));
    give(samples::update(stopped));
    EXPECT_EQ(asked<request::Jog>().back().rates, AxisRates{});
    EXPECT_FALSE(forth->isEnabled());
    QTest::mouseRelease(forth, Qt::LeftButton);
    give(samples::update(fewPlaces()));
    QTest::mousePress(forth, Qt::LeftButton);
    give(samples::refusal(fewPlaces(), requests.back().id, "the mount is not armed"));
    EXPECT_EQ(asked<request::Jog>().back().rates, AxisRates{});
    QTest::mouseRelease(forth, Qt::LeftButton);
}

TEST_F(TurnTest, SaysHowFarTheAxisMovedSince)
{
    StationStatus status = fewPlaces();
    give(samples::update(status));
    EXPECT_EQ(text("Moved since the question"), QStringLiteral("not moved"));
    status.drives->azimuth.turnQuestion->movedSince = -12.3_deg;
    give(samples::update(status));
    EXPECT_EQ(text("Moved since the question"), QStringLiteral("moved -12.3° since"));
}

// REQ-UI-13: A position on an unknown wrap never looks like a known one.
TEST_F(TurnTest, AnUnknownTurnDoesNotLookKnown)
{
    give(samples::update(fewPlaces()));
    EXPECT_EQ(text("Actual azimuth"), noValue());
    EXPECT_EQ(named<ValueLabel>("Actual azimuth")->tone(), Tone::Secondary);
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("WRAP?"));
    EXPECT_EQ(named<ValueLabel>("State of azimuth")->symbol(), Symbol::Warning);
    EXPECT_EQ(text("Error of azimuth"), QStringLiteral("---.--°"));
    EXPECT_EQ(text("Actual elevation"), QStringLiteral("20.00°"));
    EXPECT_EQ(text("State of elevation"), QStringLiteral("HOLDING"));
    const MarkerData& markers = window.findChild<SkyMarkers*>()->markers();
    EXPECT_FALSE(markers.live);
    EXPECT_FALSE(markers.commanded.has_value());
}

// Story: at each start the header showed WRAP? for two seconds, before the drives had been read.
TEST_F(TurnTest, ATurnIsNotInQuestionWhileTheDrivesAreRead)
{
    give(samples::update(samples::reading()));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("OFF"));
    EXPECT_EQ(text("Actual azimuth"), noValue());
}

TEST_F(TurnTest, WorseThanAnUnknownTurnIsSaidFirst)
{
    StationStatus status = fewPlaces();
    status.azimuth.state = AxisState::Fault;
    give(samples::update(status));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("FAULT"));
    status.azimuth.state = AxisState::Moving;
    give(samples::update(status));
    EXPECT_EQ(text("State of azimuth"), QStringLiteral("MOVING"));
    EXPECT_EQ(text("Detail of azimuth"), QStringLiteral("the cable wrap is unknown"));
}

// REQ-UI-12
TEST_F(TurnTest, GoToIsDisabledAndJoggingIsSlow)
{
    give(samples::update(fewPlaces()));
    for (const char* const name : {"Go", "Home", "Park", "Go here"}) {
        EXPECT_FALSE(named<CommandButton>(name)->isEnabled()) << name;
        EXPECT_TRUE(named<CommandButton>(name)->toolTip().contains(QLatin1String("The cable wrap of the azimuth")));
    }
    panels().setCurrentIndex(0);
    auto* const rate = named<QAbstractSlider>("Jog rate");
    EXPECT_FALSE(rate->isEnabled());
    auto* const right = named<QPushButton>("Azimuth clockwise while held");
    QTest::mousePress(right, Qt::LeftButton);
    EXPECT_EQ(asked<request::Jog>().back().rates, (AxisRates{0.2_deg_s, 0_deg_s}));
    QTest::mouseRelease(right, Qt::LeftButton);
    EXPECT_EQ(text("Rate while held"), QStringLiteral("at most 0.20°/s"));
    give(samples::update(samples::idle()));
    EXPECT_TRUE(rate->isEnabled());
    EXPECT_EQ(text("Rate while held"), QStringLiteral("2.0°/s")) << "the chosen rate comes back";
}

TEST_F(TurnTest, AStepIsAPointingAndNotOfferedOnAnUnknownTurn)
{
    give(samples::update(fewPlaces()));
    openPanel('1');
    auto* const right = named<QPushButton>("Azimuth clockwise while held");
    EXPECT_TRUE(right->isEnabled()) << "jogging is how the cable is unwound";
    auto* const pad = named<JogPad>("Jog pad");
    ASSERT_NE(pad, nullptr);
    pad->setFocus();
    QTest::keyClick(pad, Qt::Key_Return);
    QTest::keyClick(pad, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_TRUE(asked<request::Nudge>().empty());
    pad->setStepMode(true);
    give(samples::update(fewPlaces()));
    EXPECT_FALSE(right->isEnabled());
    EXPECT_TRUE(right->toolTip().contains(QStringLiteral("The cable wrap of the azimuth drive is unknown")))
        << right->toolTip().toStdString();
    give(samples::update(samples::idle()));
    EXPECT_TRUE(right->isEnabled());
}

TurnQuestion question(std::vector<Angle> candidates, std::optional<Angle> proposed = {})
{
    return {
        .candidates = std::move(candidates), .proposed = proposed, .evidence = {}, .period = 30_deg, .movedSince = {}};
}

// REQ-UI-14 (TurnChoice.*)
TEST(TurnChoice, FollowsThePickedPlaceWhileTheAxisIsJogged)
{
    TurnChoice choice;
    choice.begin(question({0_deg, 30_deg, 60_deg}));
    choice.pick(30_deg);
    choice.follow(question({10_deg, 40_deg, 70_deg}));
    EXPECT_EQ(choice.angle(), std::nullopt) << "a jump of 10° may end at any of them";
    choice.pick(40_deg);
    choice.follow(question({10.1_deg, 40.1_deg, 70.1_deg}));
    EXPECT_EQ(choice.angle(), 40.1_deg);
    choice.follow(question({40.2_deg, 70.2_deg}));
    EXPECT_EQ(choice.index(), 0u) << "the first left the travel";
}

TEST(TurnChoice, KeepsTheChoiceOfTheOperatorAgainstALaterProposal)
{
    TurnChoice choice;
    choice.begin(question({0_deg, 30_deg}));
    EXPECT_EQ(choice.angle(), std::nullopt);
    choice.follow(question({0_deg, 30_deg}, 30_deg));
    EXPECT_EQ(choice.angle(), 30_deg);
    choice.pick(0_deg);
    choice.follow(question({0_deg, 30_deg}, 30_deg));
    EXPECT_EQ(choice.angle(), 0_deg);
    choice.begin(question({0_deg, 30_deg}));
    choice.follow(question({0_deg, 30_deg}, 30_deg));
    choice.follow(question({0_deg, 30_deg}));
    EXPECT_EQ(choice.angle(), std::nullopt) << "the proposal was withdrawn";
}

TEST(TurnChoice, AnEnteredAngleHoldsOnlyWhereItWasReadOff)
{
    TurnChoice choice;
    TurnQuestion open = question({});
    choice.begin(open);
    choice.enter(12.5_deg);
    EXPECT_EQ(choice.angle(), 12.5_deg);
    EXPECT_EQ(choice.index(), std::nullopt);
    open.movedSince = 0.05_deg;
    choice.follow(open);
    EXPECT_EQ(choice.angle(), 12.5_deg);
    open.movedSince = 0.2_deg;
    choice.follow(open);
    EXPECT_EQ(choice.angle(), std::nullopt);
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/north/north_fixture.h"
#include "ui/north/calibration_bar.h"
#include "ui/window/stop_button.h"

#include <QApplication>
#include <QPlainTextEdit>
#include <QTableView>

// The panel North as a whole: its steps, STOP, Apply and Undo.
namespace boresight::ui {
namespace {

TEST_F(NorthTest, IsReachedByItsKeyAndHasFiveNumberedSteps)
{
    openPanel('9');
    EXPECT_TRUE(window.findChild<CalibrationPanel*>()->isVisible());
    ASSERT_EQ(steps().count(), 5);
    for (int step = 0; step < 5; ++step) {
        EXPECT_TRUE(steps().tabText(step).startsWith(QString::number(step + 1))) << step;
        EXPECT_FALSE(steps().tabToolTip(step).isEmpty());
    }
    EXPECT_TRUE(requests.empty()) << "looking sends nothing";
}

TEST_F(NorthTest, TheQuestionAboutATurnTakesItsPlaceAndItsKeyWhileItIsOpen)
{
    openPanel('9');
    auto* const panel = window.findChild<CalibrationPanel*>();
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    EXPECT_FALSE(panel->isVisible());
    openPanel('9');
    EXPECT_FALSE(panel->isVisible());
    give(samples::update(samples::idle()));
    openPanel('9');
    EXPECT_TRUE(panel->isVisible());
}

// REQ-UI-41
TEST_F(NorthTest, StopWorksInEveryStepAndIsNotCovered)
{
    auto* const stop = window.findChild<StopButton*>();
    std::size_t stops = 0;
    for (const auto status : {samples::swinging, samples::followingSun, samples::sixPoints}) {
        for (int step = 0; step < 5; ++step) {
            show(static_cast<CalibrationStep>(step), status());
            EXPECT_EQ(window.size(), QSize(1024, 700)) << step;
            EXPECT_EQ(window.childAt(stop->mapTo(&window, stop->rect().center())), stop) << step;
            QTest::mousePress(stop, Qt::LeftButton);
            EXPECT_EQ(asked<request::Stop>().size(), ++stops);
            QTest::mouseRelease(stop, Qt::LeftButton);
            QTest::keyClick(&window, Qt::Key_Escape);
            EXPECT_EQ(asked<request::Stop>().size(), ++stops);
        }
    }
}

// Story: at 1280×800 the end of the panel was cut off in each step, and with it Apply and Undo.
// REQ-UI-1774: In a low window only the page of a step scrolls. The tabs and the buttons below them stay in sight.
TEST_F(NorthTest, ApplyAndTheTabsStayInSight)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        for (int step = 0; step < 5; ++step) {
            show(static_cast<CalibrationStep>(step), samples::sixPoints());
            settle();
            const auto* const bar = window.findChild<CalibrationBar*>();
            EXPECT_EQ(bar->visibleRegion().boundingRect(), bar->rect()) << step;
            const auto& tabs = *steps().tabBar();
            EXPECT_EQ(tabs.visibleRegion().boundingRect().height(), tabs.height()) << step;
        }
    }
}

TEST_F(NorthTest, WithoutACalibrationDeskNothingIsOffered)
{
    StationStatus status = samples::idle();
    status.calibration = nullptr;
    for (int step = 0; step < 5; ++step) {
        show(static_cast<CalibrationStep>(step), status);
    }
    EXPECT_EQ(text("Proposed calibration"), QStringLiteral("Nothing proposed yet"));
    EXPECT_EQ(text("What Apply changes"), QStringLiteral("Steps 1 to 3 find north"));
    expectBlocked("Apply north", "Nothing is proposed yet.");
    expectBlocked("Discard the proposal", "Nothing is proposed yet.");
    expectBlocked("Undo the calibration", "There is no calibration to undo.");
    expectBlocked("Track Sun", "The position of the Sun is unknown.");
}

// REQ-UI-40: In the steps of finding north each control requests only what it says, and shows the reason if it cannot.
// Apply sends the proposal that was shown when it was pressed, with every value before and after.
TEST_F(NorthTest, ApplySendsTheProposalThatWasSeenWhenItWasPressed)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    auto* const apply = named<CommandButton>("Apply north");
    EXPECT_TRUE(text("What Apply changes").startsWith(QStringLiteral("azimuth offset 0.00° → 3")));
    EXPECT_TRUE(apply->toolTip().contains(text("What Apply changes")));
    QTest::mousePress(apply, Qt::LeftButton);
    CalibrationStatus newer = *status.calibration;
    newer.proposal->number = 8;
    status.calibration = std::make_shared<const CalibrationStatus>(newer);
    give(samples::update(status));
    QTest::mouseRelease(apply, Qt::LeftButton);
    ASSERT_EQ(wanted<request::ApplyCalibration>().size(), 1u);
    EXPECT_EQ(wanted<request::ApplyCalibration>().front().proposal, 7u);
    apply->setFocus();
    QTest::keyClick(apply, Qt::Key_Space);
    EXPECT_EQ(wanted<request::ApplyCalibration>().back().proposal, 8u);
}

TEST_F(NorthTest, DiscardSendsTheProposalThatWasSeenWhenItWasPressed)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    click("Discard the proposal");
    ASSERT_EQ(wanted<request::DiscardCalibration>().size(), 1u);
    EXPECT_EQ(wanted<request::DiscardCalibration>().front().proposal, 7u);
}

// Story: the text was for another mount and another site, and the second warning was not visible beside Apply.
// REQ-UI-1005: All warnings about the proposal are beside Apply, before the changes.
TEST_F(NorthTest, EveryWarningStandsBesideApply)
{
    StationStatus status = samples::swung();
    CalibrationStatus warned = *status.calibration;
    warned.proposal->warnings = {QStringLiteral("The text belongs to another mount."),
                                 QStringLiteral("The text belongs to another site. North and tilt may differ.")};
    status.calibration = std::make_shared<const CalibrationStatus>(warned);
    for (int step = 0; step < 5; ++step) {
        show(static_cast<CalibrationStep>(step), status);
        const QString change = text("What Apply changes");
        EXPECT_TRUE(change.startsWith(
            QStringLiteral("The text belongs to another mount. The text belongs to another site. North and tilt may "
                           "differ.\nazimuth offset 0.00° → 3")))
            << change.toStdString();
        EXPECT_EQ(named<ValueLabel>("What Apply changes")->tone(), Tone::Warning);
    }
}

StationStatus besideSteel()
{
    StationStatus status = samples::swung();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal->doubts = {QStringLiteral("Steel disturbs the compass at this heading.")};
    calibration.proposal->warnings = {QStringLiteral("North is known only to 6.1°.")};
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    return status;
}

// REQ-UI-1716: An unreliable result is marked beside Apply, and Apply asks before it sends a request. The question
// names the doubt and the changes. Only Apply anyway sends the override. Cancel has the focus and sends nothing.
TEST_F(NorthTest, AnUnreliableResultIsAppliedOnlyByApplyAnyway)
{
    show(CalibrationStep::Sensor, besideSteel());
    EXPECT_TRUE(
        text("What Apply changes")
            .startsWith(QStringLiteral("Steel disturbs the compass at this heading. North is known only to 6.1°.")))
        << text("What Apply changes").toStdString();
    EXPECT_EQ(named<ValueLabel>("Proposed calibration")->tone(), Tone::Warning);
    auto* const panel = window.findChild<CalibrationPanel*>();
    click("Apply north …");
    ASSERT_TRUE(panel->isAsking());
    const QString question = named<QPlainTextEdit>("What will happen")->toPlainText();
    EXPECT_TRUE(question.startsWith(
        QStringLiteral("This result is unreliable. Steel disturbs the compass at this heading.\n")));
    EXPECT_TRUE(question.contains(QStringLiteral("azimuth offset 0.00° → 3"))) << question.toStdString();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_FALSE(panel->isAsking());
    EXPECT_TRUE(requests.empty());

    click("Apply north …");
    click("Apply anyway");
    ASSERT_EQ(wanted<request::ApplyCalibration>().size(), 1U);
    EXPECT_EQ(wanted<request::ApplyCalibration>().front().proposal, 7U);
    EXPECT_TRUE(wanted<request::ApplyCalibration>().front().overridesDoubts);
}

// REQ-UI-1716
TEST_F(NorthTest, AReliableResultIsAppliedWithoutAQuestion)
{
    show(CalibrationStep::Sensor, samples::swung());
    click("Apply north");
    ASSERT_EQ(wanted<request::ApplyCalibration>().size(), 1U);
    EXPECT_FALSE(wanted<request::ApplyCalibration>().front().overridesDoubts);
}

// Story: the result of Sun and Moon about the level was computed and shown nowhere.
// REQ-UI-1496: The remark of the proposal about the level is beside Apply, before the changes.
TEST_F(NorthTest, WhatWasFoundOfTheLevelStandsBesideApply)
{
    StationStatus status = samples::swung();
    CalibrationStatus checked = *status.calibration;
    checked.proposal->warnings.clear();
    checked.proposal->remark = QStringLiteral("Your level is off by 0.40° ± 0.05°.");
    status.calibration = std::make_shared<const CalibrationStatus>(checked);
    show(CalibrationStep::Model, status);
    EXPECT_TRUE(text("What Apply changes")
                    .startsWith(QStringLiteral("Your level is off by 0.40° ± 0.05°.\nazimuth offset 0.00° → 3")))
        << text("What Apply changes").toStdString();
    EXPECT_EQ(named<ValueLabel>("What Apply changes")->tone(), Tone::Secondary);
}

// Story: a second press of Space on Discard undid the calibration in effect.
TEST_F(NorthTest, ASecondPressOfAButtonThatIsDoneIsNotTheNextOnes)
{
    StationStatus status = samples::sixPoints();
    show(CalibrationStep::Model, status);
    auto* const discard = named<CommandButton>("Discard the proposal");
    discard->setFocus();
    QTest::keyClick(discard, Qt::Key_Space);
    CalibrationStatus without = *status.calibration;
    without.proposal.reset();
    status.calibration = std::make_shared<const CalibrationStatus>(without);
    give(samples::update(status));
    ASSERT_FALSE(discard->isEnabled());
    ASSERT_TRUE(named<CommandButton>("Undo the calibration")->isEnabled());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_TRUE(wanted<request::UndoCalibration>().empty());
}

TEST_F(NorthTest, UndoAndRedoAreOfferedWhereThereIsSomethingAndTheHistoryWarnsOfAnotherMount)
{
    StationStatus status = samples::sixPoints();
    show(CalibrationStep::History, status);
    EXPECT_EQ(text("Calibration in force"), QStringLiteral("In force: North from the compass swing"));
    click("Undo the calibration");
    EXPECT_EQ(wanted<request::UndoCalibration>().size(), 1u);
    expectBlocked("Redo the calibration", "There is no calibration to redo.");
    auto* const table = named<QTableView>("Calibrations that were applied");
    ASSERT_EQ(table->model()->rowCount(), 2);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(1, 1)).center());
    EXPECT_TRUE(named<QPlainTextEdit>("The selected calibration")->toPlainText().contains(QStringLiteral("▲ Braga")));
    CalibrationStatus undone = *status.calibration;
    undone.canRedo = true;
    std::swap(undone.history.front().inForce, undone.history.back().inForce);
    status.calibration = std::make_shared<const CalibrationStatus>(undone);
    give(samples::update(status));
    EXPECT_TRUE(text("Calibration in force").contains(QLatin1String("other drives or another site")));
    click("Redo the calibration");
    EXPECT_EQ(wanted<request::RedoCalibration>().size(), 1u);
}

TEST_F(NorthTest, EveryControlHasANameAndIsReachedByTheTabKey)
{
    for (int step = 0; step < 5; ++step) {
        show(static_cast<CalibrationStep>(step), samples::sixPoints());
        const QWidget* const page = steps().currentWidget();
        std::vector<const QWidget*> missing;
        for (const QWidget* const widget : page->findChildren<QWidget*>()) {
            // One of several exclusive choices counts for all, because the arrow keys reach the others.
            const auto* const choice = qobject_cast<const QAbstractButton*>(widget);
            const bool byArrows = choice != nullptr && choice->group() != nullptr && !choice->isChecked();
            if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
                widget->focusProxy() == nullptr && !byArrows) {
                EXPECT_FALSE(widget->accessibleName().isEmpty())
                    << widget->metaObject()->className() << " in step " << step + 1;
                missing.push_back(widget);
            }
        }
        steps().tabBar()->setFocus();
        for (int press = 0; press < 40 && !missing.empty(); ++press) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            std::erase(missing, QApplication::focusWidget());
        }
        for (const QWidget* const widget : missing) {
            ADD_FAILURE() << widget->accessibleName().toStdString() << " is not reached in step " << step + 1;
        }
    }
    EXPECT_TRUE(requests.empty());
}

}  // namespace
}  // namespace boresight::ui

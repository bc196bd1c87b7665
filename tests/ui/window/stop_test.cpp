// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/sky/sky_markers.h"
#include "ui/window/axis_readout.h"
#include "ui/window/help_page.h"
#include "ui/window/stop_button.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QScreen>
#include <QTableWidget>

#include <gmock/gmock.h>

#include <set>
#include <string>

namespace boresight::ui {
namespace {

class StopTest : public WindowFixture
{
protected:
    StopButton& stop() { return *window.findChild<StopButton*>(); }
    std::size_t stops() const { return asked<request::Stop>().size(); }
};

// REQ-UI-01 (StopTest.*): STOP acts on press, in every state, panel and size, through dialogs and menus. Esc stops
// unless it leaves or closes something.
TEST_F(StopTest, ActsOnPressNotOnRelease)
{
    QTest::mousePress(&stop(), Qt::LeftButton);
    EXPECT_EQ(stops(), 1u);
    QTest::mouseRelease(&stop(), Qt::LeftButton);
    EXPECT_EQ(stops(), 1u);
}

TEST_F(StopTest, IsWholeAndUncoveredInEveryPanelAndLargeEnough)
{
    std::size_t presses = 0;
    for (const char panel : kPanels) {
        openPanel(panel);
        settle();
        const QRect place(stop().mapTo(&window, QPoint()), stop().size());
        EXPECT_TRUE(window.rect().contains(place));
        EXPECT_GE(place.width(), 150);
        EXPECT_GE(place.height(), 64);
        EXPECT_EQ(window.childAt(place.center()), &stop());
        QTest::mousePress(&stop(), Qt::LeftButton);
        QTest::mouseRelease(&stop(), Qt::LeftButton);
        EXPECT_EQ(stops(), ++presses);
    }
    EXPECT_EQ(window.size(), QSize(1024, 700)) << "a panel does not fit into the smallest window";
}

// Every button that opens a question or a dialog ends in "…". Each is pressed in each panel that shows it.
TEST_F(StopTest, IsThereAndWorksInEveryQuestionDialogAndPrompt)
{
    std::size_t expected = 0;
    const auto expectStopWorks = [&](const std::string& where) {
        settle();
        EXPECT_EQ(window.size(), QSize(1024, 700)) << where;
        const QRect place(stop().mapToGlobal(QPoint()), stop().size());
        EXPECT_EQ(window.childAt(stop().mapTo(&window, stop().rect().center())), &stop()) << where;
        for (QWidget* const other : QApplication::topLevelWidgets()) {
            if (other != &window && other->isVisible() && !other->inherits("QTipLabel")) {
                EXPECT_FALSE(other->frameGeometry().intersects(place)) << where << " covers STOP";
                QTest::keyClick(other, Qt::Key_F12);
                EXPECT_EQ(stops(), ++expected) << where;
            }
        }
        QTest::mousePress(&stop(), Qt::LeftButton);
        QTest::mouseRelease(&stop(), Qt::LeftButton);
        EXPECT_EQ(stops(), ++expected) << where;
        QTest::keyClick(&window, Qt::Key_Pause);
        EXPECT_EQ(stops(), ++expected) << where;
    };
    const auto closeAll = [this] {
        for (QWidget* const other : QApplication::topLevelWidgets()) {
            if (other != &window) {
                other->close();
            }
        }
    };
    int opened = 0;
    for (const auto& status : {samples::idle(), samples::factoryDrives()}) {
        give(samples::update(status));
        for (const char panel : kPanels) {
            openPanel(panel);
            const auto all = window.findChildren<QAbstractButton*>();  // the buttons of a dialog are deleted with it
            for (const QPointer<QAbstractButton>& button :
                 std::vector<QPointer<QAbstractButton>>(all.begin(), all.end())) {
                if (button && button->window() == &window && button->isVisible() && button->isEnabled() &&
                    button->text().contains(QStringLiteral("…"))) {
                    const std::string where = button->text().toStdString();
                    QTest::mouseClick(button, Qt::LeftButton);
                    expectStopWorks(where);
                    closeAll();
                    openPanel(panel == '1' ? '2' : '1');  // a question closes when its panel is left
                    openPanel(panel);
                    ++opened;
                }
            }
        }
    }
    EXPECT_GE(opened, 5) << "fix, switch off, proof, save the plot, files of the horizon";
    openPanel('1');
    QTest::keyClick(&window, Qt::Key_F1);
    expectStopWorks("help");
    closeAll();
    give(samples::update(samples::asking(Axis::Azimuth, 7, 60_deg, false)));
    expectStopWorks("the question of the turn");
    give(samples::update(samples::fighting()));
    expectStopWorks("the question of the lead");
    give(samples::update(samples::tracking(10)));
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    expectStopWorks("the limits being edited");
    window.close();
    expectStopWorks("the question before closing");
}

// Story: a prompt wider than the plot pushed STOP off the screen.
TEST_F(StopTest, StaysInPlaceWhenQuestionsAppear)
{
    give(samples::update(samples::tracking(10)));
    const QPoint before = stop().mapTo(&window, QPoint());
    auto* const sky = window.findChild<SkyMarkers*>();
    QTest::mouseClick(sky, Qt::LeftButton, {}, sky->projection().zenith.toPoint());
    window.close();
    settle();
    EXPECT_EQ(stop().mapTo(&window, QPoint()), before);
    EXPECT_EQ(window.size(), QSize(1024, 700));
}

TEST_F(StopTest, WorksInEveryState)
{
    for (const StationStatus& status : {samples::tracking(10), samples::stopped(), samples::faulted(),
                                        samples::disconnected(), samples::operatorMoving()}) {
        give(samples::update(status));
        requests.clear();
        EXPECT_TRUE(stop().isEnabled());
        QTest::keyClick(&window, Qt::Key_F12);
        QTest::mouseClick(&stop(), Qt::LeftButton);
        EXPECT_EQ(stops(), 2u);
    }
}

TEST_F(StopTest, PauseAndF12ReachThroughModalDialogsMenusAndFields)
{
    QMessageBox modal(&window);
    modal.setModal(true);
    modal.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&modal, kPatienceMs));
    QTest::keyClick(&modal, Qt::Key_Pause);
    QTest::keyClick(&modal, Qt::Key_F12);
    EXPECT_EQ(stops(), 2u);
    modal.close();

    openPanel('5');
    auto* const sources = named<QComboBox>("Filter by source");
    sources->showPopup();
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Pause);
    EXPECT_EQ(stops(), 3u);
    sources->hidePopup();

    openPanel('1');
    auto* const azimuth = named<QLineEdit>("Azimuth");
    azimuth->setFocus();
    QTest::keyClick(azimuth, Qt::Key_F12);
    EXPECT_EQ(stops(), 4u);
}

TEST_F(StopTest, EscStopsUnlessAMenuOrDialogIsOpen)
{
    window.setFocus();
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 2u);

    QTest::keyClick(&window, Qt::Key_F1, Qt::ShiftModifier);
    auto* const help = window.findChild<HelpPage*>();
    ASSERT_TRUE(becomesActive(*help));
    const auto* const readout = window.findChild<AxisReadout*>();
    EXPECT_GE(help->frameGeometry().top(), readout->mapToGlobal(readout->rect().bottomLeft()).y())
        << "neither STOP nor the numbers are covered";
    // Story: on a screen of 1280×800 its button Close and its last lines were below the edge.
    EXPECT_LE(help->frameGeometry().bottom(), help->screen()->availableGeometry().bottom());
    QTest::keyClick(help, Qt::Key_Escape);
    EXPECT_FALSE(help->isVisible());
    EXPECT_EQ(stops(), 2u);

    openPanel('5');
    auto* const sources = named<QComboBox>("Filter by source");
    sources->showPopup();
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(stops(), 2u);
}

// REQ-UI-800: Esc first leaves the part that has the keyboard: a text field, a search, a list, a table, a spin box, a
// combo box, a prompt, the presets, the editing of the sky, or the alarm card. The next Esc stops the mount. Pause and
// F12 stop at once.
TEST_F(StopTest, EscLeavesAFieldFirst)
{
    give(samples::update(samples::factoryDrives()));
    std::set<std::string> kinds;
    std::size_t expected = 0;
    for (const char panel : kPanels) {
        openPanel(panel);
        settle();
        for (QWidget* const field : window.findChildren<QWidget*>()) {
            const bool isField = field->inherits("QLineEdit") || field->inherits("QAbstractItemView") ||
                                 field->inherits("QAbstractSpinBox") || field->inherits("QComboBox") ||
                                 field->inherits("QPlainTextEdit");
            if (!isField || !field->isVisible() || !field->isEnabled() || field->focusPolicy() == Qt::NoFocus ||
                field->focusProxy() != nullptr) {
                continue;
            }
            const std::string which = std::string(1, panel) + " " + field->accessibleName().toStdString();
            kinds.insert(field->inherits("QLineEdit")           ? "text"
                         : field->inherits("QAbstractItemView") ? "list"
                         : field->inherits("QAbstractSpinBox")  ? "number"
                         : field->inherits("QComboBox")         ? "choice"
                                                                : "reading");
            field->setFocus();
            ASSERT_NE(QApplication::focusWidget(), nullptr) << which;
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_F12);
            EXPECT_EQ(stops(), ++expected) << which;
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
            EXPECT_EQ(stops(), expected) << which << ": it is left first";
            EXPECT_FALSE(field->hasFocus()) << which;
            QTest::keyClick(&window, Qt::Key_Escape);
            EXPECT_EQ(stops(), ++expected) << which;
        }
    }
    EXPECT_THAT(kinds, testing::ElementsAre("choice", "list", "number", "reading", "text"));
}

// REQ-UI-800
TEST_F(StopTest, EscDismissesAPromptThatHasTheKeyboard)
{
    auto* const sky = window.findChild<SkyMarkers*>();
    QTest::mouseClick(sky, Qt::LeftButton, {}, sky->projection().zenith.toPoint());
    auto* const goHere = named<CommandButton>("Go here");
    ASSERT_TRUE(goHere->isVisible());
    EXPECT_FALSE(goHere->hasFocus()) << "Space would move the mount";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(goHere->isVisible());
    EXPECT_EQ(stops(), 0u);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
}

// Story: after Go here the keyboard went to a button of the alarm card, and the first Esc did not stop the mount.
// REQ-UI-800
TEST_F(StopTest, AfterGoHereTheFirstEscStops)
{
    give(samples::update(samples::alarmed(alarmEntry("north.not-set"))));
    auto* const sky = window.findChild<SkyMarkers*>();
    QTest::mouseClick(sky, Qt::LeftButton, {}, sky->projection().zenith.toPoint());
    auto* const goHere = named<CommandButton>("Go here");
    QTest::mouseClick(goHere, Qt::LeftButton);
    ASSERT_FALSE(requests.empty());
    give(samples::acceptance(samples::alarmed(alarmEntry("north.not-set")), requests.back().id));
    ASSERT_FALSE(goHere->isVisible());
    EXPECT_EQ(QApplication::focusWidget(), nullptr);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
}

// REQ-UI-800
TEST_F(StopTest, EscHidesThePresetsFirst)
{
    auto* const presets = named<QPushButton>("Presets, home, horizon, unwrap");
    presets->click();
    presets->setFocus();
    QTest::keyClick(presets, Qt::Key_Escape);
    EXPECT_FALSE(presets->isChecked());
    EXPECT_EQ(stops(), 0u);
    QTest::keyClick(presets, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
}

// REQ-UI-800
TEST_F(StopTest, EscEndsTheEditingOfTheSkyFirst)
{
    auto& plot = *window.findChild<PolarPlot*>();
    plot.setEditing(true);
    QTest::mouseClick(&plot.editor(), Qt::LeftButton, {}, plot.editor().rect().center());
    ASSERT_TRUE(plot.editor().hasFocus());
    QTest::keyClick(&plot.editor(), Qt::Key_Escape);
    EXPECT_FALSE(plot.editor().isEditing());
    EXPECT_EQ(stops(), 0u);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
}

// A button of the alarm card has the keyboard after Tab. After a click on one the first Esc stops the mount.
// REQ-UI-800
TEST_F(StopTest, EscLeavesTheAlarmCardFirst)
{
    give(samples::update(samples::faulted()));
    auto* const acknowledge = named<CommandButton>("Acknowledge");
    QTest::mouseClick(acknowledge, Qt::LeftButton);
    EXPECT_FALSE(acknowledge->hasFocus());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
    acknowledge->setFocus(Qt::TabFocusReason);
    ASSERT_TRUE(acknowledge->hasFocus());
    QTest::keyClick(acknowledge, Qt::Key_Escape);
    EXPECT_EQ(stops(), 1u);
    EXPECT_FALSE(acknowledge->hasFocus());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops(), 2u);
}

// Esc in the editor of a cell reverts the typed text.
// REQ-UI-800
TEST_F(StopTest, EscTakesBackWhatIsTypedInACell)
{
    QTableWidget table(1, 1, window.centralWidget());
    table.setItem(0, 0, new QTableWidgetItem(QStringLiteral("before")));
    table.resize(200, 100);
    table.show();
    table.setCurrentCell(0, 0);
    table.editItem(table.item(0, 0));
    auto* const editor = table.findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->setFocus();
    QTest::keyClicks(editor, QStringLiteral("typed"));
    QTest::keyClick(editor, Qt::Key_Escape);
    EXPECT_EQ(table.item(0, 0)->text(), QStringLiteral("before"));
    EXPECT_EQ(stops(), 0u);
}

TEST_F(StopTest, AHeldKeyStopsOnce)
{
    QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Pause, Qt::NoModifier, QString(), true);
    QApplication::sendEvent(&window, &repeat);
    EXPECT_EQ(stops(), 0u);
}

// REQ-UI-05
TEST_F(StopTest, ShowsRequestedUntilTheStatusSaysSoThenLatchedWithReset)
{
    QTest::mousePress(&stop(), Qt::LeftButton);
    EXPECT_EQ(stop().phase(), StopButton::Phase::Requested);
    give(samples::update(samples::tracking(1)));
    EXPECT_EQ(stop().phase(), StopButton::Phase::Requested);
    auto* const reset = named<CommandButton>("Reset stop");
    EXPECT_FALSE(reset->isVisible());
    give(samples::acceptance(samples::stopped(), requests.back().id));
    EXPECT_EQ(stop().phase(), StopButton::Phase::Latched);
    ASSERT_TRUE(reset->isVisible());
    EXPECT_TRUE(stop().isVisible());

    QTest::mouseClick(reset, Qt::LeftButton);
    EXPECT_EQ(asked<request::ResetStop>().size(), 1u);
    EXPECT_TRUE(reset->isWaiting());
    give(samples::acceptance(samples::idle(), requests.back().id));
    EXPECT_FALSE(reset->isVisible());
    EXPECT_EQ(stop().phase(), StopButton::Phase::Ready);
}

TEST_F(StopTest, AnUnansweredStopIsAnAlarmAfterASecond)
{
    give(samples::update(samples::tracking(1)));
    QTest::keyClick(&window, Qt::Key_F12);
    elapse(Seconds(0.9));
    EXPECT_FALSE(text("Worst alarm").contains(QLatin1String("not confirmed")));
    elapse(Seconds(0.2));
    EXPECT_TRUE(text("Worst alarm").contains(QLatin1String("not confirmed")));
    give(samples::update(samples::tracking(2)));  // the station sends statuses, but does not stop
    EXPECT_TRUE(text("Worst alarm").contains(QLatin1String("not confirmed")));
    give(samples::update(samples::stopped()));
    EXPECT_FALSE(text("Worst alarm").contains(QLatin1String("not confirmed")));
}

// DISCONNECTED and FAULT replace the word STOPPED on the screen. The latch stays.
TEST_F(StopTest, IsConfirmedAlsoWhileTheDrivesAreSilentOrInFault)
{
    for (StationStatus status : {samples::disconnected(), samples::faulted()}) {
        give(samples::update(status));
        QTest::keyClick(&window, Qt::Key_F12);
        status.stopLatched = true;
        clock.advance(Seconds(1.1));
        give(samples::acceptance(status, requests.back().id));
        EXPECT_EQ(stop().phase(), StopButton::Phase::Latched);
        EXPECT_FALSE(text("Worst alarm").contains(QLatin1String("not confirmed")));
    }
}

TEST_F(StopTest, ARefusedStopSaysWhy)
{
    QTest::keyClick(&window, Qt::Key_F12);
    give(samples::refusal(samples::tracking(1), requests.back().id, "no drive answers"));
    EXPECT_EQ(stop().phase(), StopButton::Phase::Ready);
    bool shown = false;
    for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
        shown = shown || (label->isVisible() && label->text() == QStringLiteral("STOP: no drive answers"));
    }
    EXPECT_TRUE(shown);
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_button.h"
#include "ui/hold/jog_pad.h"
#include "ui/jog/jog_panel.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"

#include <QApplication>
#include <QLineEdit>
#include <QTabWidget>

namespace boresight::ui {
namespace {

class JogTest : public WindowFixture
{
protected:
    JogTest()
    {
        StationStatus status = samples::idle();
        status.elevation.actual = 20_deg;  // not at a limit
        status.state = StationState::Hold;
        give(samples::update(status));
    }

    JogPad& pad() { return window.findChild<JogPanel*>()->pad(); }
    JogButton& button(JogDirection direction) { return pad().button(direction); }
    std::vector<request::Jog> jogs() const { return asked<request::Jog>(); }
    bool lastJogIsZero() const { return !jogs().empty() && jogs().back().rates == AxisRates{}; }
    bool jogEnds()  // the release of a key takes effect a moment later
    {
        elapse(kJogRepeat);
        return lastJogIsZero();
    }
    void expectQuiet()
    {
        const std::size_t before = jogs().size();
        elapse(3 * kJogRepeat);
        EXPECT_EQ(jogs().size(), before);
    }
    void arm() { QTest::mouseClick(&pad(), Qt::LeftButton, {}, QPoint(20, 20)); }
    void press(int key, Qt::KeyboardModifiers modifiers = {}, bool repeat = false)
    {
        QKeyEvent event(QEvent::KeyPress, key, modifiers, QString(), repeat);
        QApplication::sendEvent(&pad(), &event);
    }
    void release(int key, Qt::KeyboardModifiers modifiers = {}, bool repeat = false)
    {
        QKeyEvent event(QEvent::KeyRelease, key, modifiers, QString(), repeat);
        QApplication::sendEvent(&pad(), &event);
    }
};

// REQ-UI-02: Jogging needs a pressed control. It ends on release, on sliding off, on loss of focus, window, panel or
// permission, and on refusal.
TEST_F(JogTest, AHeldButtonRepeatsAndReleaseEndsWithZero)
{
    QTest::mousePress(&button(JogDirection::Right), Qt::LeftButton);
    elapse(3 * kJogRepeat);
    ASSERT_EQ(jogs().size(), 4u);
    EXPECT_EQ(jogs().front().rates, (AxisRates{2_deg_s, 0_deg_s}));
    EXPECT_EQ(jogs().back().rates, (AxisRates{2_deg_s, 0_deg_s}));
    QTest::mouseRelease(&button(JogDirection::Right), Qt::LeftButton);
    EXPECT_TRUE(lastJogIsZero());
    expectQuiet();
}

TEST_F(JogTest, EachButtonMovesItsOwnWay)
{
    const std::pair<JogDirection, AxisRates> ways[] = {{JogDirection::Up, {0_deg_s, 2_deg_s}},
                                                       {JogDirection::Down, {0_deg_s, -2_deg_s}},
                                                       {JogDirection::Left, {-2_deg_s, 0_deg_s}},
                                                       {JogDirection::Right, {2_deg_s, 0_deg_s}}};
    for (const auto& [direction, rates] : ways) {
        requests.clear();
        QTest::mousePress(&button(direction), Qt::LeftButton);
        EXPECT_EQ(jogs().front().rates, rates);
        QTest::mouseRelease(&button(direction), Qt::LeftButton);
    }
}

// REQ-UI-02
TEST_F(JogTest, SlidingOffEndsItAndComingBackDoesNotMoveAgain)
{
    JogButton& up = button(JogDirection::Up);
    QTest::mousePress(&up, Qt::LeftButton);
    QTest::mouseMove(&up, QPoint(-30, 5));
    QMouseEvent away(QEvent::MouseMove, QPointF(-30, 5), up.mapToGlobal(QPointF(-30, 5)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&up, &away);
    EXPECT_TRUE(lastJogIsZero());
    QMouseEvent back(QEvent::MouseMove, QPointF(9, 9), up.mapToGlobal(QPointF(9, 9)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&up, &back);
    expectQuiet();
}

// REQ-UI-02
TEST_F(JogTest, LosingTheWindowThePanelOrThePermissionEndsIt)
{
    JogButton& right = button(JogDirection::Right);
    const auto holdThen = [&](const char* what, const std::function<void()>& event) {
        requests.clear();
        QTest::mousePress(&right, Qt::LeftButton);
        EXPECT_FALSE(lastJogIsZero());
        event();
        EXPECT_TRUE(lastJogIsZero()) << what;
        expectQuiet();
        QTest::mouseRelease(&right, Qt::LeftButton);
    };
    holdThen("window switch", [&] {
        QWidget other;
        other.show();
        other.activateWindow();
        ASSERT_TRUE(becomesActive(other));
    });
    window.activateWindow();
    ASSERT_TRUE(becomesActive(window));
    holdThen("another panel", [&] { window.findChild<QTabWidget*>()->setCurrentIndex(1); });
    window.findChild<QTabWidget*>()->setCurrentIndex(0);
    holdThen("STOP", [&] { give(samples::update(samples::stopped())); });
}

// REQ-UI-02
TEST_F(JogTest, ARefusalEndsItAndSaysWhy)
{
    QTest::mousePress(&button(JogDirection::Left), Qt::LeftButton);
    give(samples::refusal(samples::tracking(1), requests.front().id, "azimuth is not referenced"));
    EXPECT_TRUE(lastJogIsZero());
    EXPECT_FALSE(button(JogDirection::Left).isDown());
    bool shown = false;
    for (const ValueLabel* const label : pad().parentWidget()->findChildren<ValueLabel*>()) {
        shown = shown || label->text() == QStringLiteral("Jog: azimuth is not referenced");
    }
    EXPECT_TRUE(shown);
}

// REQ-UI-03: Arrow keys need arming. Auto-repeat is ignored. A minute without use disarms.
TEST_F(JogTest, ArrowKeysMoveNothingUntilArmed)
{
    pad().setFocus();
    press(Qt::Key_Right);
    release(Qt::Key_Right);
    EXPECT_TRUE(jogs().empty());
    arm();
    EXPECT_TRUE(pad().isArmed());
    press(Qt::Key_Right);
    EXPECT_EQ(jogs().front().rates, (AxisRates{2_deg_s, 0_deg_s}));
    release(Qt::Key_Right);
    EXPECT_TRUE(jogEnds());
}

// REQ-UI-03
TEST_F(JogTest, AutoRepeatIsIgnored)
{
    arm();
    press(Qt::Key_Up, {}, true);
    EXPECT_TRUE(jogs().empty());
    press(Qt::Key_Up);
    release(Qt::Key_Up, {}, true);  // X11 sends pairs of release and press while a key is pressed
    EXPECT_FALSE(lastJogIsZero());
    release(Qt::Key_Up);
    EXPECT_TRUE(jogEnds());
}

// Story: an X server sent the release and press of a repeated key one by one, and Qt took them for real ones. The axis
// was stopped and started 25 times a second.
TEST_F(JogTest, AKeyThatBouncesIsHeld)
{
    arm();
    press(Qt::Key_Right);
    for (int i = 0; i < 20; ++i) {
        release(Qt::Key_Right);
        press(Qt::Key_Right);
        elapse(Seconds(0.01));
    }
    for (const request::Jog& jog : jogs()) {
        EXPECT_EQ(jog.rates, (AxisRates{2_deg_s, 0_deg_s}));
    }
    release(Qt::Key_Right);
    EXPECT_TRUE(jogEnds());
}

// Story: a window was destroyed while a control was pressed, and sent its last "zero" to a desk that was already
// deleted.
TEST_F(JogTest, AWindowThatEndsWithAControlHeldSaysZeroLast)
{
    auto other = std::make_unique<MainWindow>(clock, settings());
    NumberedRequest last;
    QObject::connect(other.get(), &MainWindow::requested, [&](const NumberedRequest& asked) { last = asked; });
    other->showUpdate(samples::update(samples::idle()));
    other->show();
    QTest::mousePress(&other->findChild<JogPanel*>()->pad().button(JogDirection::Right), Qt::LeftButton);
    ASSERT_TRUE(std::holds_alternative<request::Jog>(last.request));
    other.reset();
    ASSERT_TRUE(std::holds_alternative<request::Jog>(last.request));
    EXPECT_EQ(std::get<request::Jog>(last.request).rates, AxisRates{});
}

TEST_F(JogTest, ShiftIsFastAndCtrlIsOneStep)
{
    arm();
    press(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_EQ(jogs().front().rates, (AxisRates{0_deg_s, 6_deg_s}));
    release(Qt::Key_Up, Qt::ShiftModifier);
    requests.clear();
    press(Qt::Key_Left, Qt::ControlModifier);
    EXPECT_TRUE(jogs().empty());
    ASSERT_EQ(asked<request::Nudge>().size(), 1u);
    EXPECT_EQ(asked<request::Nudge>().front().azimuth, -0.1_deg);
}

TEST_F(JogTest, TwoKeysMoveBothAxesUntilTheLastIsReleased)
{
    arm();
    press(Qt::Key_Up);
    press(Qt::Key_Right);
    EXPECT_EQ(jogs().back().rates, (AxisRates{2_deg_s, 2_deg_s}));
    release(Qt::Key_Up);
    elapse(kJogRepeat);
    EXPECT_EQ(jogs().back().rates, (AxisRates{2_deg_s, 0_deg_s}));
    release(Qt::Key_Right);
    EXPECT_TRUE(jogEnds());
}

// REQ-UI-03
TEST_F(JogTest, DisarmsAfterAMinuteWithoutUseAndWithTheFocus)
{
    arm();
    clock.advance(Seconds(59));
    pad().disarmWhenUnused();
    EXPECT_TRUE(pad().isArmed());
    clock.advance(Seconds(2));
    pad().disarmWhenUnused();
    EXPECT_FALSE(pad().isArmed());

    arm();
    press(Qt::Key_Up);
    named<QLineEdit>("Azimuth")->setFocus();
    EXPECT_FALSE(pad().isArmed());
    EXPECT_TRUE(lastJogIsZero());
}

TEST_F(JogTest, ChoosingARateByMouseKeepsThePadArmed)
{
    arm();
    auto* const slider = named<RateSlider>("Jog rate");
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(3, slider->height() / 2));
    EXPECT_TRUE(pad().isArmed());
    press(Qt::Key_Right);
    EXPECT_EQ(jogs().front().rates, (AxisRates{0.2_deg_s, 0_deg_s}));
    release(Qt::Key_Right);
}

// Story: the tooltip said "while held" in step mode, too.
// REQ-UI-1572: In step mode each button of the pad shows the size of its step.
TEST_F(JogTest, StepModeShowsTheStep)
{
    EXPECT_EQ(button(JogDirection::Down).toolTip(), QStringLiteral("Elevation down while held"));
    QTest::mouseClick(named<ChoiceButton>("Step mode: a press moves one step only"), Qt::LeftButton);
    QTest::mouseClick(named<ChoiceButton>("One step is 5° (Ctrl + arrow)"), Qt::LeftButton);
    EXPECT_EQ(button(JogDirection::Down).toolTip(), QStringLiteral("Elevation down by 5.00°"));
    EXPECT_EQ(button(JogDirection::Right).toolTip(), QStringLiteral("Azimuth clockwise by 5.00°"));
    QTest::mouseClick(named<ChoiceButton>("Step mode: a press moves one step only"), Qt::LeftButton);
    EXPECT_EQ(button(JogDirection::Down).toolTip(), QStringLiteral("Elevation down while held"));
}

TEST_F(JogTest, StepModeMovesOneStepPerPress)
{
    QTest::mouseClick(named<ChoiceButton>("One step is 5° (Ctrl + arrow)"), Qt::LeftButton);
    QTest::mouseClick(named<ChoiceButton>("Step mode: a press moves one step only"), Qt::LeftButton);
    QTest::mousePress(&button(JogDirection::Down), Qt::LeftButton);
    elapse(2 * kJogRepeat);
    QTest::mouseRelease(&button(JogDirection::Down), Qt::LeftButton);
    EXPECT_TRUE(jogs().empty());
    ASSERT_EQ(asked<request::Nudge>().size(), 1u);
    EXPECT_EQ(asked<request::Nudge>().front().elevation, -5_deg);
}

// REQ-UI-06
TEST_F(JogTest, AtALimitOnlyTheWayBackIsOffered)
{
    StationStatus status = samples::limited();  // azimuth at its upper end, elevation at its lower end
    give(samples::update(status));
    EXPECT_FALSE(button(JogDirection::Right).isEnabled());
    EXPECT_TRUE(button(JogDirection::Right).toolTip().contains(QStringLiteral("upper limit 150.0°")));
    EXPECT_TRUE(button(JogDirection::Left).isEnabled());
    EXPECT_FALSE(button(JogDirection::Down).isEnabled());
    EXPECT_TRUE(button(JogDirection::Up).isEnabled());
}

// REQ-UI-06: A control that cannot act is disabled and shows the reason. At a limit only the way back is offered.
TEST_F(JogTest, WhatCannotActSaysWhy)
{
    const std::pair<StationStatus, const char*> cases[] = {{samples::stopped(), "STOP is latched"},
                                                           {samples::faulted(), "Re-arm first"},
                                                           {samples::disconnected(), "no reply"}};
    for (const auto& [status, reason] : cases) {
        give(samples::update(status));
        for (const char* const name : {"Go", "Home", "Horizon", "Park", "Hold"}) {
            EXPECT_FALSE(named<CommandButton>(name)->isEnabled());
            EXPECT_TRUE(named<CommandButton>(name)->toolTip().contains(QLatin1String(reason)));
        }
    }
}

}  // namespace
}  // namespace boresight::ui

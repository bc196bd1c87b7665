// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/jog/gamepad_pilot.h"
#include "ui/jog/jog_panel.h"

#include <QLineEdit>

#include <limits>

namespace boresight::ui {
namespace {

constexpr GamepadSample kIdle{};

GamepadSample held(double right, double up)
{
    return {.right = right, .up = up, .deadMan = true};
}

// REQ-UI-02a (GamepadPilot.*): A gamepad jogs only while its dead-man switch is newly pressed, in the active window on
// the Jog panel. Unplugging it ends the jog.
TEST(GamepadPilot, TheStickCountsOnlyWhileTheDeadManIsHeld)
{
    GamepadPilot pilot;
    EXPECT_EQ(pilot.take({.right = 1.0, .up = 1.0}, true), Steering{});
    EXPECT_EQ(pilot.take(held(1.0, -1.0), true), (Steering{1.0, -1.0}));
    EXPECT_EQ(pilot.take({.right = 1.0, .up = -1.0}, true), Steering{});
}

TEST(GamepadPilot, NearItsCentreTheStickIsDeadAndBeyondItIsFine)
{
    GamepadPilot pilot;
    (void)pilot.take(kIdle, true);
    EXPECT_EQ(pilot.take(held(0.19, -0.2), true), Steering{});
    const Steering small = pilot.take(held(0.3, -0.6), true);
    EXPECT_NEAR(small.azimuth, 0.015625, 1e-9);  // ((0.3 - 0.2) / 0.8)²
    EXPECT_NEAR(small.elevation, -0.25, 1e-9);
    EXPECT_EQ(pilot.take(held(-1.3, 2.0), true), (Steering{-1.0, 1.0})) << "never more than the whole rate";
    EXPECT_EQ(pilot.take(held(std::numeric_limits<double>::quiet_NaN(), 1.0), true), Steering{});
}

TEST(GamepadPilot, WhatWasHeldBeforeNeedsAFreshPress)
{
    GamepadPilot pilot;
    EXPECT_EQ(pilot.take(held(1.0, 0.0), true), Steering{}) << "held already when it was plugged in";
    (void)pilot.take(kIdle, true);
    EXPECT_NE(pilot.take(held(1.0, 0.0), true), Steering{});
    EXPECT_EQ(pilot.take(held(1.0, 0.0), false), Steering{});
    EXPECT_EQ(pilot.take(held(1.0, 0.0), true), Steering{}) << "the window came back with it held";
    (void)pilot.take(kIdle, true);
    EXPECT_NE(pilot.take(held(1.0, 0.0), true), Steering{});
    pilot.letGo();
    EXPECT_EQ(pilot.take(held(1.0, 0.0), true), Steering{});
    pilot.gone();
    EXPECT_EQ(pilot.take(held(1.0, 0.0), true), Steering{});
}

TEST(GamepadPilot, StopIsSaidOncePerPressAlsoWhereNothingMayMove)
{
    GamepadPilot pilot;
    (void)pilot.take(kIdle, false);
    (void)pilot.take({.stop = true}, false);
    (void)pilot.take({.stop = true}, false);
    EXPECT_TRUE(pilot.takeStop());
    EXPECT_FALSE(pilot.takeStop());
}

// The samples of a gamepad at the window, and the requests to the station.
class GamepadTest : public WindowFixture
{
protected:
    GamepadTest()
    {
        StationStatus status = samples::idle();
        status.state = StationState::Hold;
        status.elevation.actual = 20_deg;
        give(samples::update(status));
        jog().showGamepad(QStringLiteral("Pad"));
        jog().takeGamepad(kIdle);
    }

    JogPanel& jog() { return *window.findChild<JogPanel*>(); }
    std::vector<request::Jog> jogs() const { return asked<request::Jog>(); }
    void push() { jog().takeGamepad(held(1.0, -1.0)); }
    bool ended() const { return !jogs().empty() && jogs().back().rates == AxisRates{}; }
};

// REQ-UI-02a (GamepadTest.*)
TEST_F(GamepadTest, AHeldDeadManRepeatsTheStickAndReleaseEndsWithZero)
{
    push();
    elapse(3 * kJogRepeat);
    ASSERT_EQ(jogs().size(), 4u);
    EXPECT_EQ(jogs().back().rates, (AxisRates{2_deg_s, -2_deg_s}));
    jog().takeGamepad(held(0.6, 0.0));
    elapse(kJogRepeat);
    EXPECT_EQ(jogs().back().rates.elevation, 0_deg_s);
    EXPECT_NEAR(jogs().back().rates.azimuth.degrees(), 0.5, 1e-9);
    jog().takeGamepad({.right = 1.0, .up = -1.0});
    EXPECT_TRUE(ended());
    const std::size_t before = jogs().size();
    elapse(3 * kJogRepeat);
    EXPECT_EQ(jogs().size(), before);
}

TEST_F(GamepadTest, UnpluggingWindowPanelRefusalAndStopEndItUntilAFreshPress)
{
    const auto expectEndBy = [this](const char* what, const std::function<void()>& event) {
        jog().takeGamepad(kIdle);
        requests.clear();
        push();
        EXPECT_FALSE(ended()) << what;
        event();
        push();
        EXPECT_TRUE(ended()) << what;
        requests.clear();
        push();
        EXPECT_TRUE(jogs().empty()) << what << ": a fresh press is needed";
    };
    const StationStatus holding = [] {
        StationStatus status = samples::operatorMoving();
        status.state = StationState::Hold;
        return status;
    }();
    expectEndBy("unplugged", [this] { jog().showGamepad({}); });
    expectEndBy("another panel", [this] { openPanel('5'); });
    openPanel('1');
    expectEndBy("STOP", [this] { give(samples::update(samples::stopped())); });
    give(samples::update(holding));
    expectEndBy("a refusal", [&] { give(samples::refusal(holding, requests.back().id, "not now")); });
    expectEndBy("Hold", [this] { QTest::keyClick(&window, Qt::Key_H, Qt::ControlModifier); });
    expectEndBy("another window", [] {
        QWidget other;
        other.show();
        other.activateWindow();
        ASSERT_TRUE(becomesActive(other));
    });
}

TEST_F(GamepadTest, AtALimitOnlyTheWayBackIsSteered)
{
    give(samples::update(samples::limited()));  // azimuth at its upper end, elevation at its lower end
    push();
    EXPECT_TRUE(jogs().empty());
    jog().takeGamepad(held(-1.0, -1.0));
    EXPECT_EQ(jogs().back().rates, (AxisRates{-2_deg_s, 0_deg_s}));
}

TEST_F(GamepadTest, ItsStopButtonStopsFromEveryPanel)
{
    openPanel('5');
    jog().takeGamepad({.stop = true});
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/hand_turned_timers.h"
#include "tests/system/simulated_station.h"
#include "tests/ui/find_widget.h"
#include "ui/hold/jog_button.h"
#include "ui/jog/jog_panel.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/sky/plot_editor.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

// From the operator to the antenna and back: the window, a real station and a simulated mount.
namespace boresight::ui {
namespace {

using system_test::SimulatedStation;

class DeskTest : public ::testing::Test
{
protected:
    DeskTest()
    {
        QObject::connect(&window, &MainWindow::requested, rig.station.get(), &Station::request);
        QObject::connect(rig.station.get(), &Station::updated, &window, &MainWindow::showUpdate);
        QObject::connect(&window, &MainWindow::updateShown, rig.station.get(), &Station::updateTaken,
                         Qt::QueuedConnection);  // as between threads
        window.resize(1024, 700);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(becomesActive(window));
        rig.onTick = [this] {
            leftmost = std::min(leftmost, rig.truth(Axis::Azimuth));
            rig.station->publish();  // its own timer runs by this computer's time
            timers.runDue();
        };
        rig.station->updateTaken();
        rig.run(Seconds(0.5));
    }

    static profile::Profile limitedProfile()
    {
        profile::Profile profile = system_test::anyPort();
        profile.limits.azimuth = {-60_deg, 200_deg};
        return profile;
    }

    template <class T>
    T& named(const char* name)
    {
        return *findNamed<T>(window, name);
    }
    void click(const char* button)
    {
        QTest::mouseClick(&named<CommandButton>(button), Qt::LeftButton);
        rig.run(Seconds(0.2));
    }
    void goTo(const char* azimuth, const char* elevation)
    {
        named<QLineEdit>("Azimuth").setText(QLatin1String(azimuth));
        named<QLineEdit>("Elevation").setText(QLatin1String(elevation));
        click("Go");
    }
    QString refusal() { return named<ValueLabel>("Refused direction").text(); }
    JogButton& button(JogDirection direction) { return window.findChild<JogPanel*>()->pad().button(direction); }

    void dragOnThePlot(SkyPointing from, SkyPointing to)
    {
        auto& plot = *window.findChild<PolarPlot*>();
        const auto pixel = [&](SkyPointing at) { return plot.markers().projection().toPixel(at).toPoint(); };
        const auto send = [&](QEvent::Type type, SkyPointing at, Qt::MouseButtons buttons) {
            QMouseEvent event(type, pixel(at), plot.editor().mapToGlobal(pixel(at)),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
            QApplication::sendEvent(&plot.editor(), &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton);
        send(QEvent::MouseMove, {(from.azimuth + to.azimuth) / 2.0, from.elevation}, Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::NoButton);
    }

    SimulatedStation rig{limitedProfile()};
    MainWindow window{rig.clock, {}};
    fakes::HandTurnedTimers timers{window, rig.clock};
    double leftmost = 1e9;  // the true azimuth
};

// REQ-UI-02d: The limit dragged on the plot is the limit that the antenna obeys.
TEST_F(DeskTest, AnAzimuthLimitDraggedOnThePlotIsEnforcedAfterApply)
{
    goTo("310", "30");  // -50°, still permitted
    ASSERT_TRUE(rig.settle());
    EXPECT_NEAR(rig.truth(Axis::Azimuth), -50.0, 0.2);
    goTo("0", "30");
    ASSERT_TRUE(rig.settle());

    QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    dragOnThePlot({300_deg, 2_deg}, {320_deg, 2_deg});
    EXPECT_EQ(rig.status().profile->limits.azimuth.min, -60_deg) << "not before Apply";
    click("Apply");
    const Angle limit = rig.status().profile->limits.azimuth.min;
    EXPECT_NEAR(limit.degrees(), -40.0, 1.0);

    leftmost = 1e9;
    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    goTo("310", "30");
    EXPECT_TRUE(refusal().contains(QStringLiteral("azimuth"))) << refusal().toStdString();
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 0.0, 0.2) << "refused is not driven to the edge";

    goTo("325", "30");  // -35°
    ASSERT_TRUE(rig.settle());
    QTest::keyClick(&named<RateSlider>("Jog rate"), Qt::Key_End);
    QTest::mousePress(&button(JogDirection::Left), Qt::LeftButton);
    rig.run(Seconds(4.0));
    QTest::mouseRelease(&button(JogDirection::Left), Qt::LeftButton);
    ASSERT_TRUE(rig.settle());
    EXPECT_NEAR(rig.truth(Axis::Azimuth), limit.degrees(), 0.2) << "the jog ended at the edge";
    EXPECT_GE(leftmost, limit.degrees() - 0.2) << "and was never beyond";
}

// REQ-UI-02
TEST_F(DeskTest, AJogEndsWithTheHandTheFocusTheWindowAndTheMouseLeaving)
{
    goTo("90", "30");
    ASSERT_TRUE(rig.settle());
    JogButton& right = button(JogDirection::Right);
    const auto slideOff = [&right] {
        QMouseEvent away(QEvent::MouseMove, QPointF(-30, 5), right.mapToGlobal(QPointF(-30, 5)), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&right, &away);
    };
    const auto otherWindow = [] {
        QWidget other;
        other.show();
        other.activateWindow();
        ASSERT_TRUE(becomesActive(other));
    };
    const std::pair<const char*, std::function<void()>> ends[] = {
        {"release", [&right] { QTest::mouseRelease(&right, Qt::LeftButton); }},
        {"sliding off", slideOff},
        {"another panel", [this] { QTest::keyClick(&window, Qt::Key_5, Qt::ControlModifier); }},
        {"another window", otherWindow}};
    for (const auto& [what, end] : ends) {
        QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
        window.activateWindow();
        ASSERT_TRUE(becomesActive(window));
        const double before = rig.truth(Axis::Azimuth);
        QTest::mousePress(&right, Qt::LeftButton);
        rig.run(Seconds(1.0));
        EXPECT_GT(rig.truth(Axis::Azimuth), before + 1.0) << what;
        EXPECT_EQ(rig.status().state, StationState::Jog) << what;
        end();
        rig.run(Seconds(0.6));  // braking from 2°/s takes 0.2 s, and the antenna swings
        const double stood = rig.truth(Axis::Azimuth);
        rig.run(Seconds(1.0));
        EXPECT_NEAR(rig.truth(Axis::Azimuth), stood, 0.02) << what;
        EXPECT_EQ(rig.status().state, StationState::Hold) << what;
        QTest::mouseRelease(&right, Qt::LeftButton);
    }
}

TEST_F(DeskTest, PresetHorizonParkAndUnparkMoveTheAntennaWhereTheySay)
{
    goTo("120", "35");
    ASSERT_TRUE(rig.settle());
    named<QLineEdit>("Name of the preset").setText(QStringLiteral("beacon"));
    rig.run(Seconds(0.2));
    click("Save here");
    ASSERT_EQ(rig.status().profile->presets.size(), 1u);
    click("Horizon");
    ASSERT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({120_deg, 0_deg}), 0.2_deg);
    click("Go to");
    ASSERT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({120_deg, 35_deg}), 0.2_deg);
    click("Home");
    ASSERT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({0_deg, 0_deg}), 0.2_deg);
    goTo("20", "10");
    ASSERT_TRUE(rig.settle());
    click("Park");
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(rig.status().state, StationState::Parked);
    rig.run(Seconds(0.2));
    click("Unpark");
    EXPECT_EQ(rig.status().state, StationState::Hold);
    click("Delete");
    EXPECT_TRUE(rig.status().profile->presets.empty());
}

// The window shows the station's answer about a direction, with the limits in effect.
// REQ-UI-24
TEST_F(DeskTest, AForbiddenDirectionIsNotOfferedAndTheNearestAllowedIs)
{
    auto& plot = *window.findChild<PolarPlot*>();
    profile::Profile drawn = *rig.status().profile;
    drawn.presets = {{"mast", {90_deg, 30_deg}}};
    drawn.limits.keepOuts = {{"mast", 60_deg, 120_deg, 0_deg, 40_deg}};
    ASSERT_EQ(rig.ask(request::ApplyProfile{drawn}), "");
    rig.run(Seconds(0.2));
    named<QLineEdit>("Name of the preset").setText(QStringLiteral("mast"));
    Q_EMIT plot.clicked({90_deg, 30_deg});
    rig.run(Seconds(0.2));
    for (const char* const name : {"Go to", "Go here"}) {
        EXPECT_FALSE(named<CommandButton>(name).isEnabled()) << name;
        EXPECT_TRUE(named<CommandButton>(name).toolTip().endsWith(QStringLiteral("forbidden: the keep-out \"mast\"")))
            << named<CommandButton>(name).toolTip().toStdString();
    }
    plot.menu().open({90_deg, 30_deg}, plot.mapToGlobal(QPoint(200, 200)));
    rig.run(Seconds(0.2));
    auto* const menu = plot.findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    for (QAction* const action : menu->actions()) {
        if (action->text().startsWith(QStringLiteral("Go to the nearest allowed"))) {
            action->trigger();
        }
    }
    ASSERT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({90_deg, 40_deg}), 0.2_deg);

    drawn.limits.keepOuts.clear();
    ASSERT_EQ(rig.ask(request::ApplyProfile{drawn}), "");
    rig.run(Seconds(0.2));
    EXPECT_TRUE(named<CommandButton>("Go to").isEnabled());
}

// A step while a client's target is tracked shifts this target, and the client keeps control.
// REQ-UI-02b
TEST_F(DeskTest, AStepDuringAPassTrimsItAndClearTakesItAway)
{
    const auto client = rig.connect();
    double azimuth = 60.0;
    const auto stream = [&](int seconds) {
        for (int second = 0; second < seconds; ++second) {
            EXPECT_EQ(client->ask("P " + std::to_string(azimuth += 1.0) + " 30.0\n"), "RPRT 0\n");
            rig.run(Seconds(1.0));
        }
    };
    stream(20);
    ASSERT_EQ(rig.status().state, StationState::Track);
    auto& pad = window.findChild<JogPanel*>()->pad();
    QTest::mouseClick(&pad, Qt::LeftButton, {}, QPoint(20, 20));
    for (int press = 0; press < 3; ++press) {
        QTest::keyClick(&pad, Qt::Key_Right, Qt::ControlModifier);
        QTest::keyClick(&pad, Qt::Key_Down, Qt::ControlModifier);
    }
    stream(3);
    EXPECT_EQ(rig.status().authority, Authority::Clients);
    ASSERT_TRUE(rig.status().trim.has_value());
    EXPECT_NEAR(rig.status().trim->azimuth.degrees(), 0.3, 1e-6);
    EXPECT_NEAR(rig.truth(Axis::Elevation), 29.7, 0.1);
    EXPECT_EQ(named<ValueLabel>("Detail of azimuth").text(), QStringLiteral("trim +0.30°"));
    click("Clear trim");
    stream(3);
    EXPECT_FALSE(rig.status().trim.has_value());
    EXPECT_NEAR(rig.truth(Axis::Elevation), 30.0, 0.1);
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
// From the first start to the first safe motion: the real window, the real station, and the simulated mount with its
// physics. The clock is turned by hand, also for the dead-man switch of the window.
#include "core/moteus_mount/link_factory.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/ui/find_widget.h"
#include "tests/ui/step_button_of.h"
#include "ui/guide/guide_page.h"
#include "ui/hold/jog_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/window/main_window.h"
#include "ui/window/stop_button.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

constexpr Seconds kTick{0.02};

profile::Profile fresh()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.mount.directions = profile::Directions::Unconfirmed;
    return profile;
}

class GuideWalk : public testing::Test
{
protected:
    GuideWalk() : links(fresh(), clock), window(clock, settings())
    {
        QObject::connect(&window, &MainWindow::requested, &window,
                         [this](const NumberedRequest& request) { station->request(request); });
        window.resize(1024, 700);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(becomesActive(window));
        connectTo(fresh());
    }

    static WindowSettings settings()
    {
        WindowSettings settings;
        settings.guide.open = true;
        return settings;
    }

    void connectTo(const profile::Profile& profile)
    {
        station.reset();
        auto made = links.make(profile.bus);
        link = dynamic_cast<SimulatedLink*>(made.get());
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(made), {folder.path(), simulationOf(Simulation::Off, profile)}),
            folder.path(), clock);
        QObject::connect(station.get(), &Station::updated, &window, &MainWindow::showUpdate);
        QObject::connect(station.get(), &Station::reconnectWanted, &window,
                         [this](const profile::Profile& wanted) { next = wanted; });
        QObject::connect(station.get(), &Station::profileApplied, &window,
                         [this](const profile::Profile& applied) { kept = applied; });
        station->openAll();
    }

    void tick()
    {
        clock.advance(kTick);
        link->deliver();
        station->tick();
        link->deliver();
        station->updateTaken();
        station->publish();
        QTest::qWait(0);
        timers.runDue();
        farthest = {
            .azimuth = std::max(farthest.azimuth, abs(link->truth(Axis::Azimuth).angle - origin.azimuth)),
            .elevation = std::max(farthest.elevation, abs(link->truth(Axis::Elevation).angle - origin.elevation))};
        fastest = std::max({fastest, abs(link->truth(Axis::Azimuth).rate), abs(link->truth(Axis::Elevation).rate)});
        if (next) {
            connectTo(*std::exchange(next, std::nullopt));
        }
    }
    bool until(const std::function<bool()>& condition, Seconds limit)
    {
        for (Seconds waited{0.0}; waited < limit; waited += kTick) {
            tick();
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    void run(Seconds time)
    {
        (void)until([] { return false; }, time);
    }
    void markPlace()
    {
        origin = {.azimuth = link->truth(Axis::Azimuth).angle, .elevation = link->truth(Axis::Elevation).angle};
        farthest = {};
        fastest = {};
    }

    GuidePage& guide() { return *window.findChild<GuidePage*>(); }
    template <class T>
    T& inGuide(const char* name)
    {
        return findSeen<T>(guide(), name);
    }
    void click(const char* name)
    {
        auto& button = inGuide<QPushButton>(name);
        EXPECT_TRUE(button.isEnabled()) << name << ": " << button.toolTip().toStdString();
        QTest::mouseClick(&button, Qt::LeftButton);
        tick();
    }
    void goTo(GuideStep step) { QTest::mouseClick(&stepButtonOf(window, step), Qt::LeftButton); }
    void hold(const char* name, Seconds time)
    {
        auto& button = inGuide<JogButton>(name);
        EXPECT_TRUE(button.isEnabled()) << name << ": " << button.toolTip().toStdString();
        QTest::mousePress(&button, Qt::LeftButton);
        run(time);
        QTest::mouseRelease(&button, Qt::LeftButton);
    }
    bool fit()
    {
        const StationStatus now = station->status();
        return now.state != StationState::Disconnected && now.drives->driveCheck == DriveCheckState::Done &&
               now.drives->armingObstacle.isEmpty() && now.azimuth.turnKnown && now.elevation.turnKnown;
    }

    fakes::ManualClock clock;
    QTemporaryDir folder;
    LinkMaker links;
    SimulatedLink* link = nullptr;
    std::optional<profile::Profile> next;
    std::optional<profile::Profile> kept;
    AxisPosition origin;
    AxisPosition farthest;
    AngularRate fastest;
    MainWindow window;
    fakes::HandTurnedTimers timers{window, clock};
    std::unique_ptr<Station> station;  // is destroyed before the window
};

// REQ-UI-35 (GuideWalk.*)
TEST_F(GuideWalk, FromTheFirstStartToTheFirstSafeMove)
{
    ASSERT_TRUE(until([this] { return fit(); }, Seconds(15.0)));
    ASSERT_TRUE(guide().isVisible());
    markPlace();
    click("Next");  // connected
    click("Next");  // protected
    EXPECT_EQ(guide().progress().current, GuideStep::Directions);

    // Only the small slow move is possible.
    station->request({.id = 900, .request = request::PointSky{{.azimuth = 113_deg, .elevation = 10_deg}}});
    run(Seconds(0.2));
    EXPECT_LT(farthest.azimuth, 0.05_deg);
    hold("Turn azimuth clockwise at 1.0°/s while held", Seconds(3.0));
    hold("Raise elevation at 1.0°/s while held", Seconds(3.0));
    ASSERT_TRUE(until([this] { return station->status().azimuth.state != AxisState::Moving; }, Seconds(5.0)));
    EXPECT_GT(farthest.azimuth, 0.5_deg);
    EXPECT_GT(farthest.elevation, 0.5_deg);
    EXPECT_LE(farthest.azimuth, 2_deg);
    EXPECT_LE(farthest.elevation, 2_deg);
    EXPECT_LE(fastest, 5_deg_s);
    ASSERT_TRUE(until([this] { return inGuide<QPushButton>("Both directions are right").isEnabled(); }, Seconds(2.0)));
    click("Both directions are right");
    tick();
    EXPECT_EQ(station->status().profile->mount.directions, profile::Directions::Confirmed);
    ASSERT_TRUE(kept) << "it is written down";

    // Level: the antenna stays where it is, and the numbers change.
    goTo(GuideStep::Level);
    markPlace();
    tick();
    inGuide<QDoubleSpinBox>("True elevation of the antenna").setValue(20.0);
    click("Set");
    ASSERT_TRUE(until(
        [this] {
            return station->status().profile->elevation.geometry.offset != 90_deg &&
                   station->status().drives->driveCheck == DriveCheckState::Done;
        },
        Seconds(20.0)));
    EXPECT_LT(farthest.elevation, 0.1_deg) << "nothing moved";
    EXPECT_EQ(station->status().profile->mount.directions, profile::Directions::Confirmed);
    // The ends stayed at the same place on the mount, so the drives' own bounds are still right.
    ASSERT_TRUE(until([this] { return fit(); }, Seconds(20.0)))
        << station->status().drives->armingObstacle.toStdString();
    ASSERT_TRUE(station->status().elevation.actual);
    EXPECT_NEAR(station->status().elevation.actual->degrees(), 20.0, 0.2);

    // Now a go-to works, and STOP ends it halfway.
    click("Finish later");
    station->request({.id = 901, .request = request::PointSky{{.azimuth = 113_deg, .elevation = 15_deg}}});
    markPlace();
    ASSERT_TRUE(until([this] { return farthest.azimuth > 30_deg; }, Seconds(30.0)));
    QTest::mousePress(window.findChild<StopButton*>(), Qt::LeftButton);
    ASSERT_TRUE(until([this] { return station->status().state == StationState::Stopped; }, Seconds(1.0)));
    ASSERT_TRUE(until([this] { return station->status().azimuth.state != AxisState::Moving; }, Seconds(5.0)));
    EXPECT_LT(farthest.azimuth, 60_deg);
}

// Boards with factory settings are unplugged and plugged in by hand. Everything else is done by keys.
// REQ-UI-974 (GuideWalk.*): Two boards with the same id are resolved in the guide alone, by the keyboard, with the
// running station.
TEST_F(GuideWalk, TwoBoardsWithOneIdAreResolvedByKeys)
{
    ASSERT_TRUE(until([this] { return fit(); }, Seconds(15.0)));
    goTo(GuideStep::Connect);
    for (const std::string command : {"conf set id.id 1\n", "conf write\n"}) {
        link->pair()
            .drive(Axis::Elevation)
            .receiveText(1, {reinterpret_cast<const std::uint8_t*>(command.data()), command.size()});
    }
    const auto boards = [this] { return station->status().drives->boards; };
    ASSERT_TRUE(until([&] { return !boards().empty() && boards().front().shared; }, Seconds(20.0)));
    EXPECT_EQ(stepButtonOf(window, GuideStep::Connect).state(), StepState::NeedsYou);
    EXPECT_FALSE(inGuide<QPushButton>("Assign to elevation …").isEnabled());

    link->pair().setFitted(Axis::Azimuth, false);
    ASSERT_TRUE(until([&] { return inGuide<QPushButton>("Assign to elevation …").isEnabled(); }, Seconds(20.0)));
    markPlace();
    const auto press = [&](const char* button) {
        inGuide<QPushButton>(button).setFocus(Qt::TabFocusReason);
        QTest::keyClick(&inGuide<QPushButton>(button), Qt::Key_Space);
        run(Seconds(0.1));
    };
    press("Assign to elevation …");
    press("Write");
    ASSERT_TRUE(until(
        [&] {
            const BoardWork work = station->status().drives->boardWork;
            return !work.running && work.text.contains(QStringLiteral("has the id 2 now"));
        },
        Seconds(20.0)))
        << station->status().drives->boardWork.text.toStdString();
    EXPECT_TRUE(inGuide<ValueLabel>("What to do with the boards").text().contains(QStringLiteral("Connect the other")));

    link->pair().setFitted(Axis::Azimuth, true);
    ASSERT_TRUE(until([&] { return station->status().drives->driveCheck == DriveCheckState::Done; }, Seconds(20.0)));
    run(Seconds(0.2));
    EXPECT_EQ(stepButtonOf(window, GuideStep::Connect).state(), StepState::Done);
    EXPECT_EQ(link->pair().drive(Axis::Azimuth).driveConfig().id, 1);
    EXPECT_EQ(link->pair().drive(Axis::Elevation).driveConfig().id, 2);
    EXPECT_LT(farthest.azimuth, 0.1_deg) << "nothing moved";
    EXPECT_LT(farthest.elevation, 0.1_deg);
}

}  // namespace
}  // namespace boresight::ui

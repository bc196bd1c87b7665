// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/commissioning.h"
#include "tests/ui/sample_permissions.h"
#include "tests/ui/step_button_of.h"
#include "tests/ui/window_fixture.h"
#include "ui/guide/guide_page.h"
#include "ui/hold/jog_button.h"
#include "ui/jog/jog_panel.h"

#include <QPushButton>

// The guide, opened for a mount that is not commissioned, and a station that accepts everything.
namespace boresight::ui {

class GuideTest : public WindowFixture
{
protected:
    GuideTest()
    {
        status = samples::freshMount();
        give(samples::update(status));
        QObject::connect(&window, &MainWindow::guideProgressed, &window,
                         [this](const GuideProgress& progress) { kept = progress; });
        QTest::keyClick(&window, Qt::Key_F3);
    }

    GuidePage& guide() { return *window.findChild<GuidePage*>(); }
    bool isOpen() { return guide().isVisible() && !window.findChild<JogPanel*>()->isVisible(); }
    StepButton& stepButton(GuideStep step) { return stepButtonOf(window, step); }
    template <class Page>
    Page& open(GuideStep step)
    {
        QTest::mouseClick(&stepButton(step), Qt::LeftButton);
        return *guide().findChild<Page*>();
    }
    // Finds a widget in the guide, not in a panel with the same widget.
    template <class T>
    T& inGuide(const char* name)
    {
        return findSeen<T>(guide(), name);
    }
    void click(const char* name) { QTest::mouseClick(&inGuide<QPushButton>(name), Qt::LeftButton); }
    GuideStep current() { return guide().progress().current; }

    // The station accepts the profile. Settings that apply at once are in effect, the others wait, and a reconnect puts
    // all in effect.
    void accept()
    {
        StationUpdate update = samples::update(status);
        update.answers.push_back({requests.back().id, std::nullopt});
        give(update);
    }
    profile::Profile lastApplied() { return asked<request::ApplyProfile>().back().profile; }
    void putInForce(const profile::Profile& profile)
    {
        status.profile = std::make_shared<const profile::Profile>(profile);
        status.simulated = profile::namesNoBus(profile);
        aim();
        give(samples::update(status));
    }
    // Applied, reconnected and in effect, as the station does with settings that need a reconnect.
    void goThroughWithReconnect()
    {
        const profile::Profile wanted = lastApplied();
        accept();
        ASSERT_EQ(asked<request::Reconnect>().size(), 1u);
        EXPECT_EQ(asked<request::Reconnect>().back().profile, wanted);
        accept();
        putInForce(wanted);
    }
    void moveTo(AxisPosition place, AxisState state = AxisState::Moving)
    {
        status.azimuth.actual = place.azimuth;
        status.elevation.actual = place.elevation;
        status.azimuth.state = state;
        status.elevation.state = state;
        const Permissions standing = samples::freshMount().permissions;
        status.permissions = state == AxisState::Moving ? samples::inMotion(standing) : standing;
        aim();
        give(samples::update(status));
    }
    // The beam points in the direction of the axis angles.
    void aim()
    {
        const AxisPosition axes{.azimuth = *status.azimuth.actual, .elevation = *status.elevation.actual};
        status.actual = pointing::upright(pointing::PointingModel(status.profile->pointing).toSky(axes));
    }
    JogButton& hold(Axis axis, bool upwards)
    {
        const char* const names[2][2] = {
            {"Turn azimuth counter-clockwise at 1.0°/s while held", "Turn azimuth clockwise at 1.0°/s while held"},
            {"Lower elevation at 1.0°/s while held", "Raise elevation at 1.0°/s while held"}};
        return inGuide<JogButton>(names[axis == Axis::Elevation][upwards]);
    }
    bool lastJogIsZero() { return !asked<request::Jog>().empty() && asked<request::Jog>().back().rates == AxisRates{}; }

    StationStatus status;
    GuideProgress kept;
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/sample_permissions.h"
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_button.h"
#include "ui/jog/jog_panel.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/command_button.h"

#include <QLineEdit>

#include <memory>
#include <utility>
#include <vector>

namespace boresight::ui {

// The controls around the jog pad: rate, steps and trim, go-to with its recent directions, presets, horizon and park.
class JogDeskTest : public WindowFixture
{
protected:
    JogDeskTest()
    {
        give(samples::update(holding()));
        QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    }

    static StationStatus holding()
    {
        StationStatus status = samples::bounded();
        status.state = StationState::Hold;
        return status;
    }
    static StationStatus withPresets(std::vector<profile::Preset> presets)
    {
        StationStatus status = holding();
        profile::Profile profile = *status.profile;
        profile.presets = std::move(presets);
        status.profile = std::make_shared<const profile::Profile>(profile);
        return status;
    }
    void click(const char* button) { QTest::mouseClick(named<CommandButton>(button), Qt::LeftButton); }
    RateSlider& slider() { return *named<RateSlider>("Jog rate"); }
    QLineEdit& presetName() { return *named<QLineEdit>("Name of the preset"); }
    void hold(JogDirection direction)
    {
        JogButton& button = window.findChild<JogPanel*>()->pad().button(direction);
        QTest::mousePress(&button, Qt::LeftButton);
        QTest::mouseRelease(&button, Qt::LeftButton);
    }
    void goTo(const char* azimuth, const char* elevation)
    {
        named<QLineEdit>("Azimuth")->setText(QLatin1String(azimuth));
        named<QLineEdit>("Elevation")->setText(QLatin1String(elevation));
        click("Go");
        give(samples::acceptance(holding(), requests.back().id));
    }
};

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/sample_calibration.h"
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_pad.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/north/calibration_panel.h"

#include <QTabBar>
#include <QTabWidget>

// The panel North and all its requests to the calibration.
namespace boresight::ui {

class NorthTest : public WindowFixture
{
protected:
    QTabWidget& steps() { return *named<QTabWidget>("Steps of finding north"); }

    // Opens a step by a click on its tab.
    void open(CalibrationStep step)
    {
        openPanel('9');
        QTabBar* const bar = steps().tabBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(static_cast<int>(step)).center());
    }
    void show(CalibrationStep step, const StationStatus& status)
    {
        open(step);
        give(samples::update(status));
    }
    void click(const char* name) { QTest::mouseClick(named<CommandButton>(name), Qt::LeftButton); }
    void choose(const char* name) { QTest::mouseClick(named<ChoiceButton>(name), Qt::LeftButton); }
    JogPad& nudgePad() { return *named<JogPad>("Nudge pad"); }

    template <class R>
    std::vector<R> wanted() const
    {
        std::vector<R> found;
        for (const CalibrationRequest& request : asked<CalibrationRequest>()) {
            if (const auto* const one = std::get_if<R>(&request)) {
                found.push_back(*one);
            }
        }
        return found;
    }
    // The button is disabled, and its tooltip gives the reason.
    void expectBlocked(const char* button, const char* reason)
    {
        EXPECT_FALSE(named<CommandButton>(button)->isEnabled()) << button;
        EXPECT_TRUE(named<CommandButton>(button)->toolTip().contains(QString::fromUtf8(reason)))
            << named<CommandButton>(button)->toolTip().toStdString();
    }
};

}  // namespace boresight::ui

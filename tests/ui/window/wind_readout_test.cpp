// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/wind_readout.h"

#include "tests/ui/find_widget.h"
#include "ui/kit/value_label.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

WindStatus breeze()
{
    return {.source = QStringLiteral("udp:4541"), .speed = 7.2, .age = Seconds(1.2)};
}

QString windShown(const WindReadout& readout, const char* accessibleName)
{
    return findNamed<ValueLabel>(readout, accessibleName)->text();
}

// REQ-WIND-50: If the profile reads the wind, the window shows the wind and the age of its last reading below the axes.
TEST(WindReadout, IsThereOnlyWithASource)
{
    WindReadout readout;
    readout.showStatus({});
    EXPECT_TRUE(readout.isHidden());
    readout.showStatus(breeze());
    EXPECT_FALSE(readout.isHidden());
    EXPECT_EQ(windShown(readout, "Wind"), QStringLiteral("Wind 7.2 m/s"));
    EXPECT_EQ(windShown(readout, "Age of the wind reading"), QStringLiteral("age 1.2 s"));
    EXPECT_EQ(windShown(readout, "What the wind forbids"), QString());
    WindStatus storm = breeze();
    storm.obstacle = QStringLiteral("The wind reached 17.0 m/s. The limit is 15.0 m/s.");
    readout.showStatus(storm);
    EXPECT_EQ(windShown(readout, "What the wind forbids"), QStringLiteral("only Park moves the mount"));
}

// Story: without a reading the wind was shown as an angle, ---.--°.
// REQ-WIND-51: An old speed is not shown. The reason why there is no reading is shown instead.
TEST(WindReadout, AnOldSpeedIsNotShown)
{
    WindStatus silent = breeze();
    silent.isSilent = true;
    silent.age = Seconds(45.0);
    silent.trouble = QStringLiteral("Boresight cannot listen on UDP 127.0.0.1:4541");
    WindReadout readout;
    readout.showStatus(silent);
    EXPECT_EQ(windShown(readout, "Wind"), QStringLiteral("Wind --.- m/s"));
    EXPECT_EQ(findNamed<ValueLabel>(readout, "Wind")->symbol(), Symbol::Lost);
    EXPECT_EQ(windShown(readout, "What the wind forbids"), silent.trouble);
}

}  // namespace
}  // namespace boresight::ui

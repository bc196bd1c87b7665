// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"

namespace boresight::ui {
namespace {

using WindowClockTest = WindowFixture;

// REQ-UI-1440: A line below the clock shows the error of the clock by its time source, and the effect on the sky for
// the tracked target. For a clock that no time source sets it shows how far the target moves in a second, and the clock
// has a question mark. The tooltip has the same in sentences, and what to do.
TEST_F(WindowClockTest, TheClockSaysHowFarItIsOff)
{
    StationStatus status = samples::operatorMoving();
    status.clock = {.synchronised = true, .error = Seconds(0.004)};
    give(samples::update(status));
    EXPECT_EQ(text("UTC"), QStringLiteral("17:06:19Z"));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("±4.0 ms"));
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS")};
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("±4.0 ms")) << "what stays needs no clock";
    status.tracked->skyRate = 3_deg_s;
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("±4.0 ms = 0.012°"));
    EXPECT_EQ(
        named<ValueLabel>("UTC")->toolTip(),
        QStringLiteral("A time source sets the clock of the station. It reports an error of 4.0 ms. That is 0.012° "
                       "for ISS."));
    status.clock.error = Seconds(1.24);
    status.tracked->skyRate = AngularRate::fromDegrees(0.004);
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("±1.2 s = 0.005°")) << "the Moon";
    status.clock = {.synchronised = false, .error = {}};
    give(samples::update(status));
    EXPECT_EQ(text("UTC"), QStringLiteral("17:06:19Z?"));
    EXPECT_EQ(named<ValueLabel>("UTC")->tone(), Tone::Warning);
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("1 s = 0.004°"));
    EXPECT_EQ(named<ValueLabel>("UTC")->toolTip(),
              QStringLiteral("No time source sets the clock of the station. Set up NTP or GPS. An error of one "
                             "second is 0.004° for ISS."));
    status.tracked.reset();
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("not set"));
}

// REQ-UI-1700: After the clock was set, and while Boresight still points by the old time, the window shows the old time
// and by how much the clock was set.
TEST_F(WindowClockTest, AClockThatWasSetIsShownAtTheClock)
{
    StationStatus status = samples::operatorMoving();
    status.clock = {.synchronised = false, .ahead = Seconds(90.0)};
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("set by +90 s"));
    EXPECT_TRUE(named<ValueLabel>("UTC")->toolTip().startsWith(
        QStringLiteral("The clock of the station was set by +90 s. Boresight still uses the old time")));
    status.clock.ahead = Seconds(-3600.0);
    give(samples::update(status));
    EXPECT_EQ(text("Error of the clock"), QStringLiteral("set by -3600 s"));
}

}  // namespace
}  // namespace boresight::ui

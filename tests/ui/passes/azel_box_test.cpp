// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"

#include <QTabWidget>

namespace boresight::ui {
namespace {

class AzelBoxTest : public WindowFixture
{
protected:
    AzelBoxTest()
    {
        openPanel('T');
        named<QTabWidget>("Passes of satellites")->setCurrentIndex(2);
    }

    static StationStatus withFile()
    {
        StationStatus status = samples::idle();
        status.azel = {.path = QStringLiteral("/home/op/.local/share/WSJT-X/azel.dat"),
                       .age = Seconds(1.2),
                       .moon = SkyPointing{105.3_deg, 59.9_deg},
                       .apart = 0.04_deg,
                       .interpolates = true,
                       .transmits = false};
        return status;
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
};

// REQ-AZEL-950: The panel Passes shows the contents of azel.dat: its Moon, its age, whether the radio transmits, and
// the difference from the computed Moon. Track Moon asks the station to track it, and Hold ends the tracking.
TEST_F(AzelBoxTest, ShowsTheFileAndAsksForItsMoon)
{
    StationStatus status = withFile();
    show(status);
    EXPECT_EQ(text("File of WSJT-X").toStdString(), "Moon by WSJT-X: 105.3° / 59.9°, 1 s old, receives");
    EXPECT_EQ(text("Moon by WSJT-X").toStdString(), "Agrees with the Moon of Boresight (0.04°).");
    QTest::mouseClick(named<CommandButton>("Track the Moon of WSJT-X"), Qt::LeftButton);
    EXPECT_EQ(asked<request::FollowAzel>().size(), 1U);

    status.azel.phase = AzelPhase::Following;
    status.azel.transmits = true;
    status.azel.next = status.utc + std::chrono::hours(3);
    show(status);
    EXPECT_TRUE(text("File of WSJT-X").endsWith(QStringLiteral("transmits")));
    EXPECT_TRUE(text("Moon by WSJT-X").contains(QStringLiteral("Tracked. Sets at 20")));
    QTest::mouseClick(named<CommandButton>("Hold and stop tracking the Moon of WSJT-X"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Hold>().size(), 1U);
    EXPECT_EQ(asked<request::FollowAzel>().size(), 1U);
}

// REQ-AZEL-951: If the file cannot be used, the panel shows the reason, and the button is blocked with the reason of
// the station. The panel also shows the reason whenever the mount stands still.
TEST_F(AzelBoxTest, ShowsWhyItStandsStill)
{
    StationStatus status = withFile();
    status.azel.moon.reset();
    status.azel.problem = QStringLiteral("there is no such file");
    status.permissions = Permissions::all();
    status.permissions.refuse(Action::FollowAzel, QStringLiteral("azel.dat cannot be used: there is no such file"));
    show(status);
    EXPECT_TRUE(text("File of WSJT-X").endsWith(QStringLiteral("WSJT-X/azel.dat")));
    EXPECT_EQ(text("Moon by WSJT-X").toStdString(), "There is no such file.");
    auto* const track = named<CommandButton>("Track the Moon of WSJT-X");
    EXPECT_FALSE(track->isEnabled());
    EXPECT_TRUE(track->toolTip().contains(QStringLiteral("there is no such file")));

    const auto shown = [&](AzelPhase phase) {
        StationStatus still = withFile();
        still.azel.phase = phase;
        still.azel.next = still.utc + std::chrono::hours(9);
        show(still);
        return text("Moon by WSJT-X").toStdString();
    };
    EXPECT_TRUE(shown(AzelPhase::Transmitting).starts_with("The mount stands still while WSJT-X transmits."));
    EXPECT_TRUE(shown(AzelPhase::Stale).starts_with("The mount waits for the file."));
    EXPECT_NE(shown(AzelPhase::BelowHorizon).find("Moon below the horizon, parked. Rises at 20"), std::string::npos);

    status = withFile();
    status.azel.apart = 0.7_deg;
    status.azel.interpolates = false;
    show(status);
    EXPECT_EQ(text("Moon by WSJT-X").toStdString(), "Differs from the Moon of Boresight by 0.70°.");
    status.azel.apart.reset();
    status.azel.transmits.reset();
    show(status);
    EXPECT_TRUE(text("File of WSJT-X").endsWith(QStringLiteral("no R or T")));
    EXPECT_EQ(text("Moon by WSJT-X").toStdString(), "Not compared, because the site is not set.");
}

// REQ-AZEL-952: The header counts the hours to the rise or set of the Moon.
TEST_F(AzelBoxTest, TheHeaderCountsInHours)
{
    StationStatus status = withFile();
    status.tracked = TrackedTarget{.name = QStringLiteral("Moon (WSJT-X)"),
                                   .isUp = false,
                                   .next = status.utc + std::chrono::hours(9) + std::chrono::minutes(5)};
    show(status);
    bool isFound = false;
    for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
        isFound = isFound || label->text().contains(QStringLiteral("Waiting for Moon (WSJT-X), rises in 9 h 5 min"));
    }
    EXPECT_TRUE(isFound);
}

}  // namespace
}  // namespace boresight::ui

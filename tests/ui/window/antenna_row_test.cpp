// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/antenna_row.h"

#include "tests/ui/window_fixture.h"
#include "ui/kit/touch_combo.h"

namespace boresight::ui {
namespace {

class AntennaRowTest : public WindowFixture
{
protected:
    static StationStatus withAntennas()
    {
        StationStatus status = samples::idle();
        status.permissions = Permissions::all();
        profile::Profile profile = *status.profile;
        profile.mount.beamWidth = 5_deg;
        profile.antennas = {{.name = "70 cm", .beamWidth = 20_deg, .across = 2_deg}};
        status.profile = std::make_shared<const profile::Profile>(profile);
        return status;
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
    // Chooses as a person does.
    void choose(int index)
    {
        box().setCurrentIndex(index);
        Q_EMIT box().activated(index);
    }
    TouchCombo& box() { return *named<TouchCombo>("Antenna"); }
};

// REQ-ANTENNA-930: If the mount has several antennas the window shows the one in use and its beam width, and another
// one can be chosen. The choice is shown when the station has accepted it. A refusal is reported. With one antenna
// there is nothing to choose.
TEST_F(AntennaRowTest, ShowsTheOneInUseAndChooses)
{
    EXPECT_FALSE(box().isVisible());
    StationStatus status = withAntennas();
    show(status);
    ASSERT_TRUE(box().isVisible());
    EXPECT_EQ(box().count(), 2);
    EXPECT_EQ(box().currentText(), QStringLiteral("main"));
    EXPECT_EQ(text("Beam of the antenna"), QStringLiteral("beam 5.00°"));
    choose(1);
    ASSERT_EQ(asked<request::UseAntenna>().size(), 1U);
    EXPECT_EQ(asked<request::UseAntenna>().back().name, "70 cm");
    EXPECT_EQ(box().currentText(), QStringLiteral("main")) << "the station has not answered yet";
    status.antenna = "70 cm";
    show(status);
    EXPECT_EQ(box().currentText(), QStringLiteral("70 cm"));
    EXPECT_EQ(text("Beam of the antenna"), QStringLiteral("beam 20.00°"));

    choose(0);
    StationUpdate refused = samples::update(status);
    refused.answers.push_back(
        {.requestId = requests.back().id, .error = Error{ErrorCode::Refused, QStringLiteral("No.")}});
    give(refused);
    EXPECT_EQ(box().currentText(), QStringLiteral("70 cm"));
    bool isTold = false;
    for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
        isTold = isTold || label->text() == QStringLiteral("Antenna: No.");
    }
    EXPECT_TRUE(isTold);
    status.permissions.refuse(Action::UseAntenna, QStringLiteral("The mount moves."));
    show(status);
    EXPECT_FALSE(box().isEnabled());
    EXPECT_EQ(box().toolTip(), QStringLiteral("The mount moves."));
}

}  // namespace
}  // namespace boresight::ui

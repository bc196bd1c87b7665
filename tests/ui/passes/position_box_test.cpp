// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"

#include <QTabWidget>

namespace boresight::ui {
namespace {

class PositionBoxTest : public WindowFixture
{
protected:
    PositionBoxTest()
    {
        openPanel('T');
        named<QTabWidget>("Passes of satellites")->setCurrentIndex(2);
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
};

// REQ-POSITION-40: The panel Passes shows the balloon or rocket whose positions arrive: direction, distance, height,
// age, and a problem. Track position asks the station to track it, and Hold ends the tracking. Without a source the box
// is hidden.
TEST_F(PositionBoxTest, ShowsWhatArrivesAndAsksForIt)
{
    StationStatus status = samples::idle();
    show(status);
    EXPECT_TRUE(named<QWidget>("Position that arrives")->isHidden() ||
                !named<QWidget>("Position that arrives")->isVisible());
    status.position = {.source = QStringLiteral("UDP 127.0.0.1:55673"),
                       .name = QStringLiteral("V2850795"),
                       .place = Site{.latitude = 46.2_deg, .longitude = 13.1_deg, .heightMetres = 12400.4},
                       .age = Seconds(1.2),
                       .direction = SkyPointing{105.3_deg, 9.9_deg},
                       .kilometres = 41.23,
                       .accepted = 120,
                       .refused = 3,
                       .refusal = QStringLiteral("the position jumped by 50.0 km in 1.0 s")};
    show(status);
    EXPECT_EQ(text("Position that arrives").toStdString(), "V2850795: 105.3° / 9.9°, 41.2 km, 12400 m high, 1 s old");
    EXPECT_EQ(text("State of the positions").toStdString(), "120 positions received, 3 refused.");
    EXPECT_TRUE(named<QWidget>("Position that arrives")->toolTip().contains(QStringLiteral("jumped by 50.0 km")));
    QTest::mouseClick(named<CommandButton>("Track the position that arrives"), Qt::LeftButton);
    EXPECT_EQ(asked<request::FollowPosition>().size(), 1U);

    status.position.phase = PositionPhase::Stale;
    status.position.problem = QStringLiteral("no position was received for 30 s");
    show(status);
    EXPECT_EQ(text("State of the positions").toStdString(),
              "The mount waits for a position. No position was received for 30 s.");
    QTest::mouseClick(named<CommandButton>("Hold and stop tracking the position"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Hold>().size(), 1U);
}

}  // namespace
}  // namespace boresight::ui

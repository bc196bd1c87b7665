// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/third_axis_row.h"

#include "tests/ui/sample_third_axis.h"
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_button.h"

namespace boresight::ui {
namespace {

class ThirdAxisRowTest : public WindowFixture
{
protected:
    ThirdAxisRowTest() { give(samples::update(withThirdAxis())); }

    static StationStatus withThirdAxis()
    {
        StationStatus status = samples::idle();
        status.thirdAxis = samples::thirdAxis();
        return status;
    }
    ThirdAxisRow& row() { return *window.findChild<ThirdAxisRow*>(); }
    std::vector<request::JogThirdAxis> jogs() const { return asked<request::JogThirdAxis>(); }
    QString report() { return findNamed<ValueLabel>(row(), "State of the third axis")->text(); }
};

// REQ-THIRD-30: The page Jog shows the name, the angle, the state, the mode, the fault and the temperature of the third
// axis. An old angle is not shown. Without such an axis it shows nothing.
TEST_F(ThirdAxisRowTest, ShowsTheAxis)
{
    const ValueLabel& place = *findNamed<ValueLabel>(row(), "Angle of the third axis");
    EXPECT_TRUE(row().isVisible());
    EXPECT_EQ(place.text(), QStringLiteral("+12.34°"));
    EXPECT_EQ(report(), QStringLiteral("HOLDING · position (10) · board 31 °C · travel -90°…90°"));
    StationStatus status = withThirdAxis();
    status.thirdAxis->state = ThirdAxisStatus::State::Fault;
    status.thirdAxis->fault = QStringLiteral("over temperature (38)");
    status.thirdAxis->age = std::chrono::milliseconds(2500);
    give(samples::update(status));
    EXPECT_TRUE(report().startsWith(QStringLiteral("FAULT · over temperature (38)"))) << report().toStdString();
    EXPECT_FALSE(place.text().contains(QStringLiteral("12.34")));
    status.thirdAxis.reset();
    give(samples::update(status));
    EXPECT_FALSE(row().isVisible());
}

// REQ-THIRD-31: Its buttons are dead-man buttons: the request is repeated while a button is pressed, and ends on
// release, when it becomes forbidden, when it is hidden, and on refusal.
TEST_F(ThirdAxisRowTest, MovesWhileAButtonIsPressed)
{
    JogButton& upper = row().upper();
    QTest::mousePress(&upper, Qt::LeftButton);
    elapse(3 * kJogRepeat);
    ASSERT_EQ(jogs().size(), 4U);
    EXPECT_EQ(jogs().back().rate, 5_deg_s);
    QTest::mouseRelease(&upper, Qt::LeftButton);
    EXPECT_EQ(jogs().back().rate, AngularRate{});
    elapse(3 * kJogRepeat);
    EXPECT_EQ(jogs().size(), 5U);
    QTest::mousePress(&row().lower(), Qt::LeftButton);
    EXPECT_EQ(jogs().back().rate, -5_deg_s);
    StationStatus stopped = withThirdAxis();
    stopped.permissions.refuse(Action::JogThirdAxisDown, QStringLiteral("STOP is latched. Reset STOP first."));
    give(samples::update(stopped));
    EXPECT_EQ(jogs().back().rate, AngularRate{});
    EXPECT_TRUE(row().lower().toolTip().contains(QStringLiteral("STOP is latched")));
    QTest::mouseRelease(&row().lower(), Qt::LeftButton);
}

// REQ-THIRD-31
TEST_F(ThirdAxisRowTest, EndsOnRefusal)
{
    QTest::mousePress(&row().upper(), Qt::LeftButton);
    StationUpdate refusal = samples::update(withThirdAxis());
    refusal.answers = {{.requestId = requests.back().id,
                        .error = Error{ErrorCode::Refused, QStringLiteral("The third axis is at the end.")}}};
    give(refusal);
    EXPECT_EQ(jogs().back().rate, AngularRate{});
    const std::size_t before = jogs().size();
    elapse(3 * kJogRepeat);
    EXPECT_EQ(jogs().size(), before);
    QTest::mouseRelease(&row().upper(), Qt::LeftButton);
}

}  // namespace
}  // namespace boresight::ui

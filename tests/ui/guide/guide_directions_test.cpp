// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_directions.h"

#include "tests/ui/guide/guide_fixture.h"
#include "ui/guide/direction_arrow.h"

// Test moves show which motor turns which axis, and in which direction.
namespace boresight::ui {
namespace {

// REQ-UI-35: The guide moves the mount only while a button or key is pressed. A mount is confirmed only after both axes
// were seen to move. A change that needs a reconnect is announced and is refused during motion. A refused change leaves
// nothing behind.
TEST_F(GuideTest, AHeldTestMoveIsSlowAndEndsOnRelease)
{
    open<GuideDirections>(GuideStep::Directions);
    for (const auto& [axis, upwards, rates] : {std::tuple{Axis::Azimuth, true, AxisRates{1_deg_s, 0_deg_s}},
                                               std::tuple{Axis::Azimuth, false, AxisRates{-1_deg_s, 0_deg_s}},
                                               std::tuple{Axis::Elevation, true, AxisRates{0_deg_s, 1_deg_s}},
                                               std::tuple{Axis::Elevation, false, AxisRates{0_deg_s, -1_deg_s}}}) {
        requests.clear();
        QTest::mousePress(&hold(axis, upwards), Qt::LeftButton);
        elapse(2 * kJogRepeat);
        ASSERT_EQ(asked<request::Jog>().size(), 3u);
        EXPECT_EQ(asked<request::Jog>().back().rates, rates);
        QTest::mouseRelease(&hold(axis, upwards), Qt::LeftButton);
        EXPECT_TRUE(lastJogIsZero());
    }
}

// REQ-UI-35
TEST_F(GuideTest, SpaceHoldsATestMoveAndEverythingThatTakesItAwayEndsIt)
{
    open<GuideDirections>(GuideStep::Directions);
    JogButton& button = hold(Axis::Azimuth, true);
    const auto begin = [&] {
        requests.clear();
        button.setFocus();
        QTest::keyPress(&button, Qt::Key_Space);
        ASSERT_FALSE(asked<request::Jog>().empty());
        EXPECT_FALSE(lastJogIsZero());
    };
    begin();
    QTest::keyRelease(&button, Qt::Key_Space);
    EXPECT_FALSE(lastJogIsZero()) << "a key may bounce";
    elapse(kJogRepeat);
    EXPECT_TRUE(lastJogIsZero()) << "release";
    begin();
    QTest::keyClick(&window, Qt::Key_Tab);
    EXPECT_TRUE(lastJogIsZero()) << "focus";
    QTest::keyRelease(&button, Qt::Key_Space);
    begin();
    openPanel('1');
    EXPECT_TRUE(lastJogIsZero()) << "another panel";
    QTest::keyClick(&window, Qt::Key_F3);
    begin();
    give(samples::update(samples::stopped()));
    EXPECT_TRUE(lastJogIsZero()) << "STOP";
    give(samples::update(status));
    begin();
    give(samples::refusal(status, requests.front().id, "no farther than 2°"));
    EXPECT_TRUE(lastJogIsZero()) << "a refusal";
    EXPECT_TRUE(inGuide<ValueLabel>("Refused").text().contains(QStringLiteral("no farther")));
}

TEST_F(GuideTest, ARepeatedKeyIsOneHold)
{
    open<GuideDirections>(GuideStep::Directions);
    JogButton& button = hold(Axis::Elevation, true);
    button.setFocus();
    QTest::keyPress(&button, Qt::Key_Space);
    for (int repeat = 0; repeat < 3; ++repeat) {  // key repeats of an X server that Qt did not detect
        QTest::keyRelease(&button, Qt::Key_Space);
        QTest::keyPress(&button, Qt::Key_Space);
    }
    for (const request::Jog& jog : asked<request::Jog>()) {
        EXPECT_EQ(jog.rates, (AxisRates{0_deg_s, 1_deg_s}));
    }
    QTest::keyRelease(&button, Qt::Key_Space);
}

// REQ-UI-35
TEST_F(GuideTest, TheArrowFollowsTheMotionAndConfirmingNeedsBothToBeSeen)
{
    open<GuideDirections>(GuideStep::Directions);
    auto& arrow = inGuide<DirectionArrow>("Direction of the azimuth");
    EXPECT_EQ(arrow.turning(), Turning::Rests);
    status.azimuth.rate = 1_deg_s;
    moveTo({.azimuth = 10.5_deg, .elevation = 20_deg});
    EXPECT_EQ(arrow.turning(), Turning::Grows);
    EXPECT_EQ(arrow.accessibleDescription(), QStringLiteral("clockwise, seen from above"));
    status.azimuth.rate = -1_deg_s;
    moveTo({.azimuth = 10.4_deg, .elevation = 20_deg});
    EXPECT_EQ(arrow.turning(), Turning::Shrinks);
    auto& confirm = inGuide<QPushButton>("Both directions are right");
    EXPECT_FALSE(confirm.isEnabled());
    EXPECT_TRUE(confirm.toolTip().contains(QStringLiteral("elevation")));
    status.azimuth.rate = 0_deg_s;
    moveTo({.azimuth = 10.4_deg, .elevation = 19.5_deg});
    moveTo({.azimuth = 10.4_deg, .elevation = 19.5_deg}, AxisState::Holding);
    ASSERT_TRUE(confirm.isEnabled());
    QTest::mouseClick(&confirm, Qt::LeftButton);
    EXPECT_EQ(lastApplied().mount.directions, profile::Directions::Confirmed);
    accept();
    putInForce(lastApplied());
    EXPECT_TRUE(asked<request::Reconnect>().empty()) << "it applies at once";
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Done);
    click("Next");
    EXPECT_EQ(current(), GuideStep::Travel);
}

// Story: no axis that the mount has was left to be moved, and the directions could not be confirmed.
// REQ-MOUNT-03
TEST_F(GuideTest, OfAMountWithOneAxisThatOneHasToBeSeen)
{
    status.capabilities.axes[index(Axis::Elevation)].reset();
    open<GuideDirections>(GuideStep::Directions);
    moveTo({.azimuth = 10.2_deg, .elevation = 20_deg});
    moveTo({.azimuth = 10.2_deg, .elevation = 20_deg}, AxisState::Holding);
    auto& confirm = inGuide<QPushButton>("The direction is right");
    EXPECT_FALSE(confirm.isEnabled()) << "too little to be seen";
    moveTo({.azimuth = 12_deg, .elevation = 20_deg});
    moveTo({.azimuth = 12_deg, .elevation = 20_deg}, AxisState::Holding);
    EXPECT_TRUE(confirm.isEnabled()) << confirm.toolTip().toStdString();
    for (const char* const name : {"EL moved the wrong way", "The other axis moved:\nswap the motors"}) {
        EXPECT_FALSE(findNamed<QPushButton>(guide(), name)->isVisible()) << name;
    }
}

TEST_F(GuideTest, WrongMotorsAreSwappedAndAWrongDirectionReversedByOnePress)
{
    open<GuideDirections>(GuideStep::Directions);
    moveTo({.azimuth = 11_deg, .elevation = 21_deg});
    EXPECT_FALSE(inGuide<QPushButton>("AZ moved the wrong way").isEnabled()) << "not in motion";
    moveTo({.azimuth = 11_deg, .elevation = 21_deg}, AxisState::Holding);
    click("The other axis moved:\nswap the motors");
    EXPECT_EQ(lastApplied().azimuth.id, 2);
    EXPECT_EQ(lastApplied().elevation.id, 1);
    goThroughWithReconnect();
    EXPECT_FALSE(inGuide<QPushButton>("Both directions are right").isEnabled()) << "to be seen anew";
    requests.clear();
    click("AZ moved the wrong way");
    EXPECT_EQ(lastApplied().azimuth.geometry.sign, -1);
    EXPECT_NEAR(lastApplied().azimuth.geometry.offset.degrees(), -22.0, 1e-9) << "it reads 11° as before";
    goThroughWithReconnect();
    EXPECT_EQ(lastApplied().mount.directions, profile::Directions::Unconfirmed);
}

}  // namespace
}  // namespace boresight::ui

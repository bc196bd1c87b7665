// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/guide/guide_fixture.h"
#include "ui/guide/guide_north.h"
#include "ui/guide/guide_site.h"
#include "ui/guide/guide_travel.h"
#include "ui/guide/guide_zero.h"
#include "ui/north/calibration_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLineEdit>

// Ends of travel, level, north and site: the steps that set numbers.
namespace boresight::ui {
namespace {

TEST_F(GuideTest, EndsAreTypedOrSetWhereTheMountStands)
{
    open<GuideTravel>(GuideStep::Travel);
    EXPECT_FALSE(inGuide<QPushButton>("Use these ends").isEnabled());
    QTest::mouseClick(&inGuide<QPushButton>("Set the lower end of azimuth here"), Qt::LeftButton);
    inGuide<QDoubleSpinBox>("Upper end of azimuth").setValue(380.0);
    auto& lowest = inGuide<QDoubleSpinBox>("Lower end of elevation");
    lowest.setFocus();
    lowest.selectAll();
    QTest::keyClicks(&lowest, QStringLiteral("95"));
    QTest::keyClick(&lowest, Qt::Key_Tab);
    give(samples::update(status));
    EXPECT_FALSE(inGuide<QPushButton>("Use these ends").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Use these ends").toolTip().contains(QStringLiteral("not below")));
    lowest.setValue(5.0);
    give(samples::update(status));
    EXPECT_TRUE(requests.empty()) << "nothing changes before it is used";
    click("Use these ends");
    EXPECT_EQ(lastApplied().azimuth.geometry.travel, (TravelRange{.min = 10_deg, .max = 380_deg}));
    EXPECT_EQ(lastApplied().elevation.geometry.travel, (TravelRange{.min = 5_deg, .max = 90_deg}));
    EXPECT_EQ(lastApplied().park, (AxisPosition{.azimuth = 10_deg, .elevation = 5_deg})) << "it came inside";
    goThroughWithReconnect();
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Done);
}

TEST_F(GuideTest, LevelIsSetHereAndItsEffectToldBefore)
{
    open<GuideZero>(GuideStep::Level);
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Holding);
    EXPECT_TRUE(
        inGuide<ValueLabel>("The angle that the elevation reports now").text().contains(QStringLiteral("3.20°")));
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("-3.20°")));
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("-3.2°…86.8°")));
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Moving);
    EXPECT_FALSE(inGuide<QPushButton>("Set").isEnabled()) << "not in motion";
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Holding);
    inGuide<QCheckBox>("Keep cable and stops physically where they are").click();
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("0.0°…90.0°")));
    click("Set");
    EXPECT_NEAR(lastApplied().elevation.geometry.offset.degrees(), 93.2, 1e-9);
    EXPECT_EQ(lastApplied().elevation.geometry.travel, status.profile->elevation.geometry.travel);
    goThroughWithReconnect();
    EXPECT_EQ(stepButton(GuideStep::Level).state(), StepState::Done);
}

// REQ-UI-43: Setting north by a landmark in the guide changes only the pointing model, at once.
TEST_F(GuideTest, NorthIsSetInThePointingModelAtOnceAndTheCableKeepsItsNumbers)
{
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Moving);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled()) << "not in motion";
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    EXPECT_TRUE(inGuide<ValueLabel>("Where the antenna points now").text().contains(QStringLiteral("10.00°")));
    inGuide<QDoubleSpinBox>("True azimuth of the antenna").setValue(350.0);
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("from 0.00° to -20.00°")));
    const auto connects = asked<request::Reconnect>().size();
    click("Set north");
    EXPECT_NEAR(lastApplied().pointing.azimuthOffset.degrees(), -20.0, 1e-9);
    EXPECT_EQ(lastApplied().azimuth.geometry, status.profile->azimuth.geometry);
    EXPECT_EQ(lastApplied().limits, status.profile->limits);
    EXPECT_EQ(asked<request::Reconnect>().size(), connects) << "it applies now";
}

// Story: north could not be set on a mount without an elevation axis, because the elevation could not be set.
// REQ-MOUNT-03
TEST_F(GuideTest, NorthIsSetOfAMountThatHasNoElevation)
{
    status.capabilities.axes[index(Axis::Elevation)].reset();
    status.permissions.refuse(Action::SetElevation, QStringLiteral("This mount has no elevation axis."));
    give(samples::update(status));
    open<GuideNorth>(GuideStep::North);
    inGuide<QDoubleSpinBox>("True azimuth of the antenna").setValue(350.0);
    EXPECT_TRUE(inGuide<QPushButton>("Set north").isEnabled())
        << inGuide<QPushButton>("Set north").toolTip().toStdString();
}

// REQ-MOUNT-15: The guide has no step, no row and no button for an axis that the mount does not have.
TEST_F(GuideTest, WhatBelongsToAMissingAxisIsLeftOut)
{
    status.capabilities.axes[index(Axis::Elevation)].reset();
    give(samples::update(status));
    open<GuideTravel>(GuideStep::Travel);
    EXPECT_TRUE(findNamed<QDoubleSpinBox>(guide(), "Lower end of azimuth")->isVisible());
    EXPECT_FALSE(findNamed<QDoubleSpinBox>(guide(), "Lower end of elevation")->isVisible());
    EXPECT_FALSE(stepButton(GuideStep::Level).isVisible());
    click("Next");
    EXPECT_EQ(current(), GuideStep::North);
    click("Back");
    EXPECT_EQ(current(), GuideStep::Travel);
}

// REQ-MOUNT-15
TEST_F(GuideTest, AStepOfAMissingAxisIsGoneOnFrom)
{
    open<GuideNorth>(GuideStep::North);
    status.capabilities.axes[index(Axis::Azimuth)].reset();
    give(samples::update(status));
    EXPECT_EQ(current(), GuideStep::Site);
    EXPECT_FALSE(stepButton(GuideStep::North).isVisible());
    EXPECT_TRUE(stepButton(GuideStep::Level).isVisible());
}

// Story: F3 and one click on "Set north" with the default 0.00° replaced a north that was already found by -21.30°.
TEST_F(GuideTest, ANorthThatIsKnownIsReplacedOnlyOnPurpose)
{
    CalibrationStatus calibration;
    calibration.history = {{.when = status.utc,
                            .title = QStringLiteral("Pointing model from 3 points"),
                            .change = {},
                            .place = {},
                            .inForce = true}};
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    profile::Profile known = *status.profile;
    known.pointing.azimuthOffset = 38.11_deg;
    putInForce(known);
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    const QString told = inGuide<ValueLabel>("What to do").text();
    EXPECT_TRUE(told.contains(QStringLiteral("azimuth offset 38.11°"))) << told.toStdString();
    EXPECT_TRUE(told.contains(QStringLiteral("Pointing model from 3 points"))) << told.toStdString();
    auto& truth = inGuide<QDoubleSpinBox>("True azimuth of the antenna");
    EXPECT_NEAR(truth.value(), 48.11, 1e-9) << "what the beam reads";
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled()) << "nobody has typed anything";
    truth.setValue(0.0);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled()) << "not on purpose yet";
    EXPECT_TRUE(inGuide<QPushButton>("Set north").toolTip().contains(QStringLiteral("North is known")));
    const QString effect = inGuide<ValueLabel>("What the change does").text();
    EXPECT_TRUE(effect.contains(QStringLiteral("from 38.11° to -10.00°"))) << effect.toStdString();
    EXPECT_TRUE(effect.contains(QStringLiteral("press Undo on the page Profile")))
        << "the way back: " << effect.toStdString();
    inGuide<QCheckBox>("Replace the known north").click();
    click("Set north");
    EXPECT_NEAR(lastApplied().pointing.azimuthOffset.degrees(), -10.0, 1e-9);
    accept();
    putInForce(lastApplied());
    open<GuideNorth>(GuideStep::North);
    EXPECT_FALSE(inGuide<QCheckBox>("Replace the known north").isChecked()) << "once is not for ever";
    EXPECT_NEAR(truth.value(), 0.0, 1e-9) << "what the beam reads now";
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
}

// Story: 210 was typed, Skip was pressed, and north was found in the panel. Back in the guide one click replaced it by
// 210.
TEST_F(GuideTest, WhatWasTypedForNorthIsForgottenWhenTheStepIsLeft)
{
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    auto& truth = inGuide<QDoubleSpinBox>("True azimuth of the antenna");
    truth.setValue(210.0);
    EXPECT_TRUE(inGuide<QPushButton>("Set north").isEnabled());
    open<QWidget>(GuideStep::Site);
    open<GuideNorth>(GuideStep::North);
    EXPECT_NEAR(truth.value(), 10.0, 1e-9) << "what the beam reads";
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
}

TEST_F(GuideTest, WhatWasTypedForNorthIsOfOneMountAlone)
{
    profile::Profile other = *status.profile;
    other.bus = "socketcan:can0";
    putInForce(other);
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    inGuide<QDoubleSpinBox>("True azimuth of the antenna").setValue(210.0);
    EXPECT_TRUE(inGuide<QPushButton>("Set north").isEnabled());
    other.bus = "socketcan:can1";
    putInForce(other);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
}

// Story: the field was cleared and left, and "Set north" used the earlier number as if it was typed.
TEST_F(GuideTest, AnEmptiedNorthIsNotATypedOne)
{
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    auto& truth = inGuide<QDoubleSpinBox>("True azimuth of the antenna");
    truth.setFocus();
    truth.selectAll();
    QTest::keyClick(&truth, Qt::Key_Delete);
    give(samples::update(status));
    EXPECT_EQ(truth.cleanText(), QString()) << "somebody is about to type";
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Set north").toolTip().contains(QStringLiteral("Type the true azimuth first.")));
    QTest::keyClick(&truth, Qt::Key_Tab);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
    truth.setFocus();
    truth.selectAll();
    QTest::keyClicks(&truth, QStringLiteral("-"));
    give(samples::update(status));
    EXPECT_EQ(truth.cleanText(), QStringLiteral("-"));
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled()) << "not a number yet";
    QTest::keyClicks(&truth, QStringLiteral("20"));
    EXPECT_TRUE(inGuide<QPushButton>("Set north").isEnabled());
}

TEST_F(GuideTest, ANorthOfAnotherPlaceIsNotCalledKnown)
{
    CalibrationStatus calibration;
    calibration.otherMount = QStringLiteral("another site");
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    profile::Profile moved = *status.profile;
    moved.pointing.azimuthOffset = 38.11_deg;
    putInForce(moved);
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    EXPECT_FALSE(inGuide<ValueLabel>("What to do").text().contains(QStringLiteral("North is known")));
}

// REQ-UI-973: The guide adapts to the connected hardware: without a sensor none is offered, without boards none are
// listed, and for a rotator without readable settings the step Protect is left out.
TEST_F(GuideTest, TheOtherWaysToNorthAreOnePressAway)
{
    open<GuideNorth>(GuideStep::North);
    status.sensor.source.clear();
    give(samples::update(status));
    (void)inGuide<QPushButton>("Sun, Moon (Ctrl+9)");  // for a mount without a sensor
    EXPECT_TRUE(inGuide<ValueLabel>("What to do").text().contains(QStringLiteral("has no sensor")));
    status.sensor.source = QStringLiteral("serial /dev/ttyUSB0");
    give(samples::update(status));
    QTest::mouseClick(&inGuide<QPushButton>("Sensor, Sun, Moon (Ctrl+9)"), Qt::LeftButton);
    EXPECT_FALSE(window.findChild<GuidePage*>()->isVisible());
    EXPECT_TRUE(window.findChild<CalibrationPanel*>()->isVisible());
}

TEST_F(GuideTest, AZeroNeedsAKnownTurn)
{
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    open<GuideNorth>(GuideStep::North);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Set north").toolTip().contains(QStringLiteral("wrap")));
}

TEST_F(GuideTest, SiteAndLocatorFollowEachOther)
{
    open<GuideSite>(GuideStep::Site);
    EXPECT_FALSE(inGuide<QPushButton>("Set the site").isEnabled());
    auto& locator = inGuide<QLineEdit>("Maidenhead locator");
    locator.setFocus();
    QTest::keyClicks(&locator, QStringLiteral("JN58t"));
    EXPECT_FALSE(inGuide<ValueLabel>("What is wrong").text().isEmpty());
    QTest::keyClicks(&locator, QStringLiteral("d"));
    EXPECT_EQ(locator.text(), QStringLiteral("JN58td"));
    EXPECT_NEAR(inGuide<QDoubleSpinBox>("Latitude").value(), 48.146, 0.001);  // published: 48°08.75' N, 11°37.5' E
    EXPECT_NEAR(inGuide<QDoubleSpinBox>("Longitude").value(), 11.625, 0.001);
    inGuide<QDoubleSpinBox>("Longitude").setValue(-8.5);
    EXPECT_EQ(locator.text(), QStringLiteral("IN58sd"));
    inGuide<QDoubleSpinBox>("Height").setValue(523.0);
    click("Set the site");
    EXPECT_TRUE(lastApplied().site.known);
    EXPECT_NEAR(lastApplied().site.longitude.degrees(), -8.5, 1e-9);
    EXPECT_EQ(lastApplied().site.heightMetres, 523.0);
    accept();
    putInForce(lastApplied());
    EXPECT_EQ(stepButton(GuideStep::Site).state(), StepState::Done);
}

}  // namespace
}  // namespace boresight::ui

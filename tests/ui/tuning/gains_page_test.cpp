// SPDX-License-Identifier: GPL-3.0-or-later
// The gains of a drive in the tuning panel.
#include "ui/tuning/gains_page.h"

#include "tests/ui/tuning/tuning_fixture.h"
#include "ui/tuning/gains_model.h"

#include <QDoubleSpinBox>

namespace boresight::ui {
namespace {

class GainsPageTest : public TuningFixture
{
protected:
    GainsPageTest()
    {
        open<TuningPanel>();
        show();
        press("Gains");
    }

    void select(Gain gain)
    {
        named<QTableView>("Gains")->setCurrentIndex(window.findChild<GainsModel*>()->index(static_cast<int>(gain), 0));
    }
    QDoubleSpinBox& box() { return *named<QDoubleSpinBox>("New value of the selected gain"); }
    GainLine& line(Gain gain) { return gains().lines[static_cast<std::size_t>(gain)]; }
    bool isWriteEnabled() { return named<CommandButton>("Write")->isEnabled(); }
};

// REQ-UI-932: A gain is changed in the table within its bounds. A gain on trial is marked. Storing asks first and lists
// the changes.
TEST_F(GainsPageTest, AGainIsChangedAndStored)
{
    select(Gain::Damping);
    EXPECT_DOUBLE_EQ(box().value(), kFoundDamping);
    box().setValue(99999.0);
    EXPECT_NEAR(box().value(), 40212.4, 0.001) << "no more than the bounds";
    box().setValue(12000.0);
    click("Write");
    ASSERT_EQ(asked<request::SetGain>().size(), 1U);
    EXPECT_EQ(asked<request::SetGain>().back().gain, Gain::Damping);
    EXPECT_DOUBLE_EQ(asked<request::SetGain>().back().value, 12000.0);

    gains() = sampleGains(kOtherDamping);
    show();
    EXPECT_TRUE(says(window, "On trial, not stored"));
    click("Store …");
    EXPECT_TRUE(questionText().contains(QStringLiteral("servo.sample: 10053.1 → 12000")));
    EXPECT_TRUE(asked<request::StoreGains>().empty());
    QTest::mouseClick(act("Store"), Qt::LeftButton);
    EXPECT_EQ(asked<request::StoreGains>().size(), 1U);
}

// Story: a feed-forward of 0.0001 was shown as 0.000, and a step from 0 was 0.
// REQ-TUNING-28: A gain is shown with the decimals that its bounds need, and can be stepped from 0.
TEST_F(GainsPageTest, SmallGainsAreShownAndStepped)
{
    GainLine& small = line(Gain::InertiaFeedforward);
    small.value = 1e-4;
    small.least = 0.0;
    small.most = 4e-4;
    show();
    select(Gain::InertiaFeedforward);
    EXPECT_DOUBLE_EQ(box().value(), 1e-4);
    EXPECT_TRUE(box().text().startsWith(QStringLiteral("0.0001"))) << box().text().toStdString();
    small.value = 0.0;
    show();
    EXPECT_DOUBLE_EQ(box().value(), 0.0);
    box().stepUp();
    EXPECT_GT(box().value(), 1e-6);
    EXPECT_LT(box().value(), 1e-4);
    select(Gain::Stiffness);
    EXPECT_EQ(box().text().toStdString(), "201062") << "no decimals that the drive does not print";
    box().stepUp();
    EXPECT_NEAR(box().value(), 211062.0, 1.0);
}

// Story: Write without an edit wrote the value that the box had rounded.
// REQ-TUNING-29: A gain that was not edited is not written.
TEST_F(GainsPageTest, WriteNeedsAnEdit)
{
    line(Gain::Stiffness).value = 201062.4;
    show();
    select(Gain::Stiffness);
    expectBlocked("Write", "This value is in force");
    box().stepUp();
    EXPECT_TRUE(isWriteEnabled());
    box().stepDown();
    EXPECT_FALSE(isWriteEnabled());
    line(Gain::Stiffness).stored = 200000.0;
    line(Gain::Stiffness).least = 50000.0;
    line(Gain::Stiffness).most = 800000.0;
    show();
    EXPECT_FALSE(isWriteEnabled()) << "other bounds are no edit";
    box().setValue(800001.0);
    click("Write");
    ASSERT_EQ(asked<request::SetGain>().size(), 1U);
    EXPECT_DOUBLE_EQ(asked<request::SetGain>().back().value, 800000.0);
}

// Story: whenever the permission to write changed, the typed value was overwritten.
// REQ-TUNING-30: A typed gain stays until the axis, the row or the value in effect changes.
TEST_F(GainsPageTest, ATypedGainStays)
{
    select(Gain::Damping);
    box().setValue(12000.0);
    status.permissions.refuse(Action::SetAzimuthGains, QStringLiteral("The mount moves. Stop it first."));
    show();
    expectBlocked("Write", "The mount moves");
    EXPECT_DOUBLE_EQ(box().value(), 12000.0);
    status.permissions = samples::idle().permissions;
    line(Gain::Stiffness).value = 150000.0;
    line(Gain::Damping).stored = 9000.0;
    line(Gain::Damping).most = 36000.0;
    show();
    EXPECT_DOUBLE_EQ(box().value(), 12000.0);
    line(Gain::Damping).value = 9000.0;
    show();
    EXPECT_DOUBLE_EQ(box().value(), 9000.0);
    box().setValue(12000.0);
    select(Gain::IntegralLimit);
    EXPECT_DOUBLE_EQ(box().value(), 60.0);
    box().setValue(70.0);
    status.drives->elevation.gains = sampleGains();
    show();
    EXPECT_DOUBLE_EQ(box().value(), 70.0);
    press("Elevation");
    EXPECT_DOUBLE_EQ(box().value(), 60.0);
}

// REQ-TUNING-31: Restoring asks first if the encoder filter is among the gains, because the wrap is unknown afterwards.
TEST_F(GainsPageTest, PutBackAsksBeforeTheFilter)
{
    gains() = sampleGains(kOtherDamping);
    show();
    click("Put back");
    EXPECT_EQ(asked<request::PutGainsBack>().size(), 1U);
    give(samples::acceptance(status, requests.back().id));
    line(Gain::EncoderFilter).value = 300.0;
    show();
    click("Put back");
    EXPECT_TRUE(questionText().contains(QStringLiteral("The cable wrap of the azimuth is unknown")));
    EXPECT_EQ(asked<request::PutGainsBack>().size(), 1U);
    QTest::mouseClick(act("Put back"), Qt::LeftButton);
    EXPECT_EQ(asked<request::PutGainsBack>().size(), 2U);
}

// REQ-TUNING-32: Every gain that needs the drives off asks first and has the permission for this.
TEST_F(GainsPageTest, WhatNeedsTheDrivesOffAsksFirst)
{
    line(Gain::IntegralLimit).needsOff = true;
    status.permissions.refuse(Action::SetAzimuthFilter, QStringLiteral("Switch the drives off first."));
    show();
    select(Gain::IntegralLimit);
    box().setValue(70.0);
    expectBlocked("Write", "Switch the drives off");
    status.permissions = samples::idle().permissions;
    show();
    click("Write");
    EXPECT_TRUE(asked<request::SetGain>().empty());
    QTest::mouseClick(act("Write"), Qt::LeftButton);
    ASSERT_EQ(asked<request::SetGain>().size(), 1U);
    EXPECT_EQ(asked<request::SetGain>().back().gain, Gain::IntegralLimit);
}

}  // namespace
}  // namespace boresight::ui

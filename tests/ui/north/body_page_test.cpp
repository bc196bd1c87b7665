// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/north/north_fixture.h"
#include "ui/hold/jog_button.h"
#include "ui/kit/format.h"
#include "ui/kit/touch_combo.h"
#include "ui/north/calibration_words.h"
#include "ui/north/scan_plot.h"

#include <QCheckBox>
#include <QDoubleSpinBox>

// Sun, Moon, landmark and the peak of the power: step 3 of finding north.
namespace boresight::ui {
namespace {

// REQ-UI-41: While the Sun is chosen the complete warning about eyes and feed is shown, in every language. STOP works
// and is not covered in any step. The tests also write pictures to look at.
TEST_F(NorthTest, AsLongAsTheSunIsMeantTheWarningStandsThere)
{
    show(CalibrationStep::Body, samples::beforeCalibration());
    EXPECT_EQ(text("Eyes and feed"), sunWarning());
    choose("Points by the Moon");
    EXPECT_TRUE(text("Eyes and feed").isEmpty());
    give(samples::update(samples::followingSun()));
    EXPECT_TRUE(text("Eyes and feed").startsWith(QLatin1String("The antenna points at the Sun")))
        << "while the beam is there, whatever is looked at";
    choose("Points by the Sun");
    EXPECT_FALSE(text("Eyes and feed").isEmpty());
}

TEST_F(NorthTest, SunAndMoonAreFollowedWithTheRefractionChosen)
{
    show(CalibrationStep::Body, samples::sixPoints());
    EXPECT_TRUE(text("Position of the body").startsWith(QStringLiteral("az 143.2°  el 52.1°, sets 20:39Z")));
    auto* const refraction = named<TouchCombo>("Refraction");
    refraction->setFocus();
    QTest::keyClick(refraction, Qt::Key_Down);
    click("Track Sun");
    ASSERT_EQ(wanted<request::FollowBody>().size(), 1u);
    EXPECT_EQ(wanted<request::FollowBody>().front().body, ephemeris::Body::Sun);
    EXPECT_EQ(wanted<request::FollowBody>().front().refraction, ephemeris::Refraction::Radio);
    choose("Points by the Moon");
    EXPECT_TRUE(text("Position of the body").contains(QLatin1String("below the horizon, rises 22:43Z")));
    expectBlocked("Track Moon", "below the lowest elevation");
}

TEST_F(NorthTest, OverTheTopIsOfferedToABoomThatGoesThere)
{
    show(CalibrationStep::Body, samples::sixPoints());
    auto* const overTheTop = named<QCheckBox>("Over the top");
    EXPECT_FALSE(overTheTop->isVisible());

    StationStatus status = samples::sixPoints();
    status.elevation.travel.max = 180_deg;
    give(samples::update(status));
    ASSERT_TRUE(overTheTop->isVisible());
    overTheTop->setFocus();
    QTest::keyClick(overTheTop, Qt::Key_Space);
    click("Track Sun");
    ASSERT_EQ(wanted<request::FollowBody>().size(), 1u);
    EXPECT_TRUE(wanted<request::FollowBody>().front().overTheTop);
    choose("Points by the Moon");
    expectBlocked("Track Moon", "do not permit this direction over the top");

    give(samples::update(samples::followingOverTheTop()));
    choose("Points by the Sun");
    EXPECT_TRUE(text("Position of the body").contains(QLatin1String("tracked over the top, trim")));
    EXPECT_TRUE(overTheTop->isChecked());
    EXPECT_FALSE(overTheTop->isEnabled()) << "for the next time it is followed";
    give(samples::update(samples::sixPoints()));  // the travel was narrowed
    click("Track Sun");
    EXPECT_FALSE(wanted<request::FollowBody>().back().overTheTop);
}

TEST_F(NorthTest, AFollowedBodyIsTrimmedByThePadAndTakenAsAPoint)
{
    show(CalibrationStep::Body, samples::followingSun());
    QTest::mousePress(&nudgePad().button(JogDirection::Right), Qt::LeftButton);
    QTest::mouseRelease(&nudgePad().button(JogDirection::Right), Qt::LeftButton);
    ASSERT_EQ(asked<request::Nudge>().size(), 1u);
    EXPECT_NEAR(asked<request::Nudge>().front().azimuth.degrees(), 0.1, 1e-9);
    EXPECT_TRUE(asked<request::Jog>().empty()) << "a jog would end the following";
    auto* const step = named<TouchCombo>("Step of the pad");
    QTest::keyClick(step, Qt::Key_Home);
    nudgePad().setFocus();
    QTest::keyClick(&nudgePad(), Qt::Key_Up);
    EXPECT_EQ(asked<request::Nudge>().size(), 1u) << "arrow keys need arming here, too";
    QTest::keyClick(&nudgePad(), Qt::Key_Return);
    QTest::keyClick(&nudgePad(), Qt::Key_Up);
    ASSERT_EQ(asked<request::Nudge>().size(), 2u);
    EXPECT_NEAR(asked<request::Nudge>().back().elevation.degrees(), 0.01, 1e-9);
    click("Take point");
    EXPECT_EQ(wanted<request::TakePoint>().size(), 1u);
    EXPECT_TRUE(text("Position of the body").contains(QLatin1String("points taken: 3")));
    click("Hold and stop tracking the Sun");
    EXPECT_EQ(asked<request::Hold>().size(), 1u);
}

TEST_F(NorthTest, APointCanNotBeTakenBeforeTheBodyIsFollowed)
{
    show(CalibrationStep::Body, samples::beforeCalibration());
    expectBlocked("Take point", "Track the Sun first.");
}

TEST_F(NorthTest, ALandmarkIsTakenWithItsNameAndDirection)
{
    show(CalibrationStep::Body, samples::sixPoints());
    choose("A landmark whose direction is known");
    auto* const azimuth = named<QDoubleSpinBox>("True azimuth of the landmark");
    azimuth->setFocus();
    azimuth->selectAll();
    QTest::keyClicks(azimuth, QStringLiteral("271.25"));
    auto* const elevation = named<QDoubleSpinBox>("True elevation of the landmark");
    elevation->setFocus();
    elevation->selectAll();
    QTest::keyClicks(elevation, QStringLiteral("1.5"));
    QTest::keyClicks(named<QLineEdit>("Name of the landmark"), QStringLiteral(" church tower "));
    EXPECT_TRUE(requests.empty()) << "typing takes nothing";
    click("Store the landmark as a point");
    ASSERT_EQ(wanted<request::TakeKnownPoint>().size(), 1u);
    const auto taken = wanted<request::TakeKnownPoint>().front();
    EXPECT_NEAR(taken.truth.azimuth.degrees(), 271.25, 1e-9);
    EXPECT_NEAR(taken.truth.elevation.degrees(), 1.5, 1e-9);
    EXPECT_EQ(taken.label, QStringLiteral("church tower"));
}

TEST_F(NorthTest, ALandmarkThatNobodyHasToldIsNotTaken)
{
    show(CalibrationStep::Body, samples::sixPoints());
    choose("A landmark whose direction is known");
    expectBlocked("Store the landmark as a point", "Type the direction");
    QTest::keyClicks(named<QLineEdit>("Name of the landmark"), QStringLiteral("mast in the north"));
    click("Store the landmark as a point");
    ASSERT_EQ(wanted<request::TakeKnownPoint>().size(), 1u);
    EXPECT_EQ(wanted<request::TakeKnownPoint>().front().truth.azimuth.degrees(), 0.0);
}

TEST_F(NorthTest, TheScanWaitsForTypedPowersAndTakesNumbersOnly)
{
    show(CalibrationStep::Body, samples::followingSun());
    choose("The peak of the received power, by a cross scan");
    expectBlocked("Enter dB", "No scan waits");
    named<QDoubleSpinBox>("Width of the scan")->setValue(8.0);
    click("Scan Sun");
    ASSERT_EQ(wanted<request::StartCrossScan>().size(), 1u);
    EXPECT_NEAR(wanted<request::StartCrossScan>().front().width.degrees(), 8.0, 1e-9);
    give(samples::update(samples::scanning()));
    auto* const power = named<QLineEdit>("Received power in dB");
    power->setFocus();
    QTest::keyClicks(power, QStringLiteral("loud"));
    QTest::keyClick(power, Qt::Key_Return);
    EXPECT_TRUE(wanted<request::GivePower>().empty());
    EXPECT_EQ(power->text(), QStringLiteral("loud")) << "stays to be corrected";
    power->selectAll();
    QTest::keyClicks(power, QStringLiteral("-73.2"));
    QTest::keyClick(power, Qt::Key_Return);
    ASSERT_EQ(wanted<request::GivePower>().size(), 1u);
    EXPECT_NEAR(wanted<request::GivePower>().front().decibels, -73.2, 1e-9);
    give(samples::acceptance(samples::scanning(), requests.back().id));
    EXPECT_TRUE(power->text().isEmpty());
    click("End scan");
    EXPECT_EQ(wanted<request::EndCalibration>().size(), 1u);
}

// Story: the Moon was tracked, the Sun was chosen, and the page offered to scan the Moon.
TEST_F(NorthTest, TheScanIsOfTheBodyThatWasChosenLast)
{
    show(CalibrationStep::Body, samples::followingSun());
    choose("Points by the Moon");
    choose("The peak of the received power, by a cross scan");
    expectBlocked("Scan Moon", "below");
    EXPECT_FALSE(text("Eyes and feed").isEmpty()) << "the beam still looks into the Sun";
    choose("Points by the Sun");
    choose("The peak of the received power, by a cross scan");
    click("Scan Sun");
    ASSERT_EQ(wanted<request::StartCrossScan>().size(), 1u);
    EXPECT_EQ(wanted<request::StartCrossScan>().front().body, ephemeris::Body::Sun);
    choose("Points by the Moon");
    give(samples::update(samples::scanning()));
    choose("The peak of the received power, by a cross scan");
    EXPECT_NE(nullptr, named<CommandButton>("End scan")) << "of the Sun, that runs";
}

TEST_F(NorthTest, TheChoicesStayWhereTheyAre)
{
    show(CalibrationStep::Body, samples::followingSun());
    auto* const sun = named<ChoiceButton>("Points by the Sun");
    auto* const peak = named<ChoiceButton>("The peak of the received power, by a cross scan");
    const auto places = [&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        return std::pair(QRect(sun->mapTo(sun->window(), QPoint()), sun->size()),
                         QRect(peak->mapTo(peak->window(), QPoint()), peak->size()));
    };
    const auto before = places();
    choose("The peak of the received power, by a cross scan");
    EXPECT_EQ(before, places());
}

TEST_F(NorthTest, HowFarTheBeamIsBesideTheBodyIsTold)
{
    StationStatus status = samples::sixPoints();
    show(CalibrationStep::Body, status);
    SkyPointing beside = bodyNow(status, ephemeris::Body::Sun)->direction;
    beside.elevation += 3.24_deg;
    status.actual = beside;
    give(samples::update(status));
    EXPECT_TRUE(text("Position of the body").contains(QStringLiteral("not tracked, beam 3.2° off")))
        << qPrintable(text("Position of the body"));
    status.actual.reset();
    give(samples::update(status));
    EXPECT_TRUE(text("Position of the body").contains(QLatin1String("\nnot tracked\n")));
}

// Story: the page always proposed 6°, three beam widths of one operator's dish, and nothing was found.
TEST_F(NorthTest, TheScanOffersTwiceTheBeam)
{
    StationStatus status = samples::followingSun();
    const auto tell = [&](Angle beam) {
        profile::Profile profile = *status.profile;
        profile.mount.beamWidth = beam;
        status.profile = std::make_shared<const profile::Profile>(profile);
        give(samples::update(status));
    };
    show(CalibrationStep::Body, status);
    choose("The peak of the received power, by a cross scan");
    auto* const width = named<QDoubleSpinBox>("Width of the scan");
    tell(2_deg);
    EXPECT_DOUBLE_EQ(width->value(), 4.0);
    tell(0.05_deg);
    EXPECT_DOUBLE_EQ(width->value(), 0.2);
    tell(60_deg);
    EXPECT_DOUBLE_EQ(width->value(), 40.0) << "no wider than the station permits";
    width->setValue(5.5);
    tell(3_deg);
    EXPECT_DOUBLE_EQ(width->value(), 5.5) << "as typed";
}

TEST_F(NorthTest, TheScanTellsAndShowsWhatItFound)
{
    show(CalibrationStep::Body, samples::scanned());
    choose("The peak of the received power, by a cross scan");
    const calibration::CrossScan scan = *samples::scanned().calibration->scan;
    EXPECT_EQ(text("What the scan found"),
              QStringLiteral("Peak: across +0.60° ± %1, elevation -0.40° ± %2; beam 2.0° × 2.0°, 3.0 dB over the "
                             "background")
                  .arg(angleText(scan.across.offset.sigma), angleText(scan.elevation.offset.sigma)));
    auto* const plot = named<ScanPlot>("Power along both lines of the scan");
    ASSERT_TRUE(plot->isVisible());
    give(samples::update(samples::scanning()));
    EXPECT_TRUE(text("What the scan found").isEmpty());
    EXPECT_FALSE(plot->isVisible());
}

// REQ-UI-40a
TEST_F(NorthTest, TheScanTellsWhatTheReceiverSays)
{
    StationStatus status = samples::followingSun();
    show(CalibrationStep::Body, status);
    choose("The peak of the received power, by a cross scan");
    EXPECT_TRUE(text("Power of the receiver").isEmpty()) << "the profile names none";
    const auto tell = [&](const PowerLineStatus& line) {
        CalibrationStatus calibration = *status.calibration;
        calibration.powerLine = line;
        status.calibration = std::make_shared<const CalibrationStatus>(calibration);
        give(samples::update(status));
    };
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540")});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("UDP 127.0.0.1:4540: no data yet"));
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540"), .decibels = -73.25, .age = Seconds(2.2)});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("UDP 127.0.0.1:4540: -73.3 dB, 2 s old"));
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540"),
          .problem = QStringLiteral("No data"),
          .decibels = -73.25,
          .age = Seconds(9.0)});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("No data"));
    EXPECT_EQ(named<ValueLabel>("Power of the receiver")->symbol(), Symbol::Warning);
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/north/north_fixture.h"
#include "ui/kit/page_room.h"
#include "ui/north/compass_dial.h"
#include "ui/north/deviation_plot.h"
#include "ui/north/sensor_levels.h"

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QPlainTextEdit>
#include <QSpinBox>

#include <algorithm>

// The sensor and the compass swing: steps 1 and 2 of finding north.
namespace boresight::ui {
namespace {

TEST_F(NorthTest, TheAverageOfTheSensorIsAskedAndEnded)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Sensor, status);
    click("Average");
    EXPECT_EQ(wanted<request::MeasureSensorOffset>().size(), 1u);
    CalibrationStatus running = *status.calibration;
    running.progress = {
        .run = CalibrationRun::SensorOffset, .done = 0.5, .left = Seconds(10), .text = {}, .outcome = {}};
    status.calibration = std::make_shared<const CalibrationStatus>(running);
    give(samples::update(status));
    click("End average");
    EXPECT_EQ(wanted<request::EndCalibration>().size(), 1u);
    running.progress = {.outcome = QStringLiteral("the samples disagree"), .failed = true};
    status.calibration = std::make_shared<const CalibrationStatus>(running);
    give(samples::update(status));
    EXPECT_EQ(text("Average of the sensor"), QStringLiteral("the samples disagree"));
    EXPECT_EQ(named<ValueLabel>("Average of the sensor")->symbol(), Symbol::Warning);
}

TEST_F(NorthTest, TheSimulatedMountWithoutASensorOffersItsOwn)
{
    StationStatus status = samples::idle();
    status.simulated = true;
    CalibrationStatus without;
    without.sensorObstacle = QStringLiteral("The profile has no orientation sensor.");
    status.calibration = std::make_shared<const CalibrationStatus>(without);
    show(CalibrationStep::Sensor, status);
    click("Use the sensor");
    const auto applied = asked<request::ApplyProfile>();
    ASSERT_EQ(applied.size(), 1u);
    profile::Profile wanted = *status.profile;
    wanted.sensor.source = profile::SensorSource::Simulated;
    EXPECT_EQ(applied[0].profile, wanted);
    EXPECT_TRUE(asked<CalibrationRequest>().empty());

    status.simulated = false;
    give(samples::update(status));
    expectBlocked("Average", "The profile has no orientation sensor.");
}

// REQ-UI-1702: The page Sensor asks whether the sensor applies the declination of the site. The answer in force is
// marked, its effect is shown beside it, and another answer changes the profile at once.
TEST_F(NorthTest, TheDeclinationIsAQuestionWithTwoAnswers)
{
    StationStatus status = samples::heard();
    status.sensor.declinationText = QStringLiteral("The sensor applies the declination (+5.07°).");
    show(CalibrationStep::Sensor, status);
    auto& yes = *named<CommandButton>("Yes, the sensor applies the declination");
    auto& no = *named<CommandButton>("No, Boresight applies the declination");
    EXPECT_TRUE(yes.isChecked());
    EXPECT_FALSE(no.isChecked());
    EXPECT_TRUE(text("Where the declination is applied").startsWith(QStringLiteral("The sensor applies")));
    QTest::mouseClick(&no, Qt::LeftButton);
    const auto applied = asked<request::ApplyProfile>();
    ASSERT_EQ(applied.size(), 1u);
    profile::Profile wanted = *status.profile;
    wanted.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    EXPECT_EQ(applied[0].profile, wanted);
    give(samples::update(status));
    EXPECT_TRUE(yes.isChecked()) << "until the station has the new profile in force";
    EXPECT_FALSE(no.isChecked());
    status.profile = std::make_shared<const profile::Profile>(wanted);
    give(samples::update(status));
    EXPECT_FALSE(yes.isChecked());
    EXPECT_TRUE(no.isChecked());
}

// REQ-UI-978: Details shows, in the place of the dial, all that the sensor reports: revolutions, its time and
// temperature, the firmware with unknown parts of its status, and refused data by reason. Old values show their age.
// Copy copies it as text.
TEST_F(NorthTest, DetailsShowAllThatTheSensorReports)
{
    StationStatus status = samples::swung();
    orientation::Orientation heard;
    heard.extendedAzimuth = 417.4_deg;
    heard.elevation = 33.2_deg;
    heard.revolutions = 1;
    heard.temperature = 27.0;
    status.sensor = {.source = QStringLiteral("MQTT broker:1883"), .open = true, .last = heard};
    status.sensor.age = std::chrono::milliseconds(400);
    status.sensor.firmware =
        orientation::SensorState{.version = "2.0.6b", .bssid = "B8:69:F4:81:8D:E6", .unknown = "{\"rssi\":-71}"};
    status.sensor.firmwareAge = std::chrono::minutes(5);
    status.sensor.counts.accepted = 812;
    status.sensor.counts.count(orientation::Refusal::NotFinite);
    status.sensor.counts.count(orientation::Refusal::NotFinite);
    show(CalibrationStep::Sensor, status);
    const auto press = [this](const char* name) { QTest::mouseClick(named<QPushButton>(name), Qt::LeftButton); };
    EXPECT_TRUE(window.findChild<CompassDial*>()->isVisible());
    press("Show the details");
    EXPECT_FALSE(window.findChild<CompassDial*>()->isVisible());
    const auto lines = [&] {
        press("Copy the details");
        return QApplication::clipboard()->text().split(QLatin1Char('\n'));
    };
    for (const char* const line :
         {"azimuth as sent\t417.40°", "revolutions as sent\t1", "temperature\t27 °C", "firmware\t2.0.6b (5 min ago)",
          "WiFi access point\tB8:69:F4:81:8D:E6 (5 min ago)", "rssi\t-71 (5 min ago)", "messages used\t812",
          "messages refused\t2", "refused: not a finite number\t2"}) {
        EXPECT_TRUE(lines().contains(QString::fromUtf8(line))) << line << lines().join(QLatin1Char('\n')).toStdString();
    }
    status.sensor.age = std::chrono::seconds(12);
    give(samples::update(status));
    EXPECT_TRUE(lines().contains(QStringLiteral("temperature\t27 °C (12 s ago)"))) << "old, and says so";
    press("Show the details");
    EXPECT_TRUE(window.findChild<CompassDial*>()->isVisible());
}

TEST_F(NorthTest, TheNeedlesAreWhatIsReadAndTheBarsSayWhatRaisesThem)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Sensor, status);
    const auto& dial = *window.findChild<CompassDial*>();
    EXPECT_FALSE(dial.sensor().has_value()) << "nothing was heard of a sensor";
    EXPECT_EQ(text("Heading of the sensor, as sent"), QStringLiteral("---.--°"));
    orientation::Orientation heard;
    heard.heading = orientation::SensorHeading::folded(417.4_deg);
    heard.calibration = orientation::Calibration{.system = 1, .gyro = 3, .accelerometer = 2, .magnetometer = 0};
    status.sensor.source = QStringLiteral("simulated");
    status.sensor.presence = orientation::Presence::Present;
    status.sensor.last = heard;
    give(samples::update(status));
    EXPECT_NEAR(dial.sensor()->angle().degrees(), 57.4, 1e-9);
    EXPECT_NEAR(dial.axis()->degrees(), 20.0, 1e-9);
    EXPECT_EQ(text("Sensor minus axis"), QStringLiteral("+37.40°"));
    EXPECT_EQ(named<LevelBar>("Gyro calibration")->level(), 3);
    EXPECT_EQ(named<LevelBar>("Compass calibration")->level(), 0);
    EXPECT_EQ(text("Compass: how to raise it"), QStringLiteral("figure of eight, away from iron"));
    EXPECT_EQ(named<ValueLabel>("Compass: how to raise it")->symbol(), Symbol::Warning);
    EXPECT_EQ(text("Gyro: how to raise it"), QStringLiteral("good"));
    status.sensor.presence = orientation::Presence::Lost;
    give(samples::update(status));
    EXPECT_FALSE(dial.sensor().has_value()) << "an old heading is not shown as a live one";
}

// REQ-UI-40
TEST_F(NorthTest, ASensorThatIsNoEvidenceIsNotAveragedAndSaysWhy)
{
    show(CalibrationStep::Sensor, samples::beforeCalibration());
    expectBlocked("Average", "calibrated to 1 of 3");
    EXPECT_TRUE(text("Average of the sensor").contains(QLatin1String("calibrated to 1 of 3")));
}

TEST_F(NorthTest, TheSwingIsPlannedInWordsBeforeItStarts)
{
    show(CalibrationStep::Swing, samples::sixPoints());
    EXPECT_TRUE(text("Compass swing").contains(QLatin1String("takes 4 min")));
    named<QDoubleSpinBox>("Rate of the swing")->setFocus();
    QTest::keyClick(named<QDoubleSpinBox>("Rate of the swing"), Qt::Key_Up);
    QTest::keyClick(named<QSpinBox>("Headings to stop at"), Qt::Key_PageUp);
    ASSERT_EQ(wanted<request::PlanSwing>().size(), 2u);
    EXPECT_NEAR(wanted<request::PlanSwing>().back().rate.degrees(), 3.5, 1e-9);
    EXPECT_EQ(wanted<request::PlanSwing>().back().headings, 10);
    EXPECT_TRUE(wanted<request::StartSwing>().empty());
    click("Start swing");
    ASSERT_EQ(wanted<request::StartSwing>().size(), 1u);
    EXPECT_NEAR(wanted<request::StartSwing>().front().rate.degrees(), 3.5, 1e-9);
    EXPECT_EQ(wanted<request::StartSwing>().front().headings, 10);
}

// REQ-UI-40
TEST_F(NorthTest, ARefusedSwingSaysWhyBesideItsButtonAndKeepsWhatWasTyped)
{
    show(CalibrationStep::Swing, samples::sixPoints());
    named<QDoubleSpinBox>("Rate of the swing")->setValue(2.0);
    click("Start swing");
    give(samples::refusal(samples::sixPoints(), requests.back().id, "the range is too small for a swing"));
    const auto* const panel = shownPage(*named<QTabWidget>("Steps of finding north"));
    bool told = false;
    for (const ValueLabel* const label : panel->findChildren<ValueLabel*>()) {
        told =
            told || (label->isVisible() && label->text() == QLatin1String("Start swing: the range is too small for a "
                                                                          "swing"));
    }
    EXPECT_TRUE(told);
    EXPECT_EQ(named<QDoubleSpinBox>("Rate of the swing")->value(), 2.0);
}

TEST_F(NorthTest, ASwingThatRunsShowsHowFarItIsAndCanBeEnded)
{
    show(CalibrationStep::Swing, samples::swinging());
    EXPECT_TRUE(text("Compass swing").contains(QLatin1String("143 samples")));
    EXPECT_TRUE(text("Compass swing").contains(QLatin1String("2 min left")));
    click("End swing");
    EXPECT_EQ(wanted<request::EndCalibration>().size(), 1u);
    expectBlocked("Average", "A calibration is running");
    expectBlocked("Track Sun", "A calibration is running");
}

// REQ-UI-42: The deviation curve agrees with Qwt's own scale. Directions of turning, readings left out and unreliable
// sectors differ in shape.
TEST_F(NorthTest, TheDeviationCurveLiesWhereItsSamplesAreAndShowsBothWays)
{
    const StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    settle();
    auto& plot = *window.findChild<DeviationPlot*>();
    const SwingOutcome& swing = *status.calibration->swing;
    ASSERT_FALSE(swing.fit.samples.empty());
    QImage image(plot.size(), QImage::Format_RGB32);
    plot.render(&image);
    int curve = 0;
    for (int heading = 5; heading < 360; heading += 5) {
        const Angle at = Angle::fromDegrees(heading);
        const QPoint pixel = plot.pixel(at, swing.fit.curve.deviation(at)).toPoint();
        const auto isCurve = [&](int below) {
            return image.pixelColor(pixel + QPoint(0, below)) == currentTheme().accent;
        };
        curve += isCurve(-1) || isCurve(0) || isCurve(1) ? 1 : 0;
    }
    EXPECT_GT(curve, 60) << "of 71 places, the curve is painted where Qwt's own scale says";
    for (const auto& one : swing.fit.samples) {
        if (one.fate == calibration::SampleFate::Used) {
            EXPECT_LE(one.error.degrees(), plot.highest());
            EXPECT_GE(one.error.degrees(), plot.lowest());
        }
    }
    const QString found = named<QPlainTextEdit>("Result of the swing")->toPlainText();
    EXPECT_TRUE(found.startsWith(QStringLiteral("North ")));
    EXPECT_TRUE(found.contains(QStringLiteral("leans by 0.60° ± 0.05°")));
}

TEST_F(NorthTest, AHopelessPlaceIsSaidFirstAndNothingOfItCanBeApplied)
{
    show(CalibrationStep::Swing, samples::swungInVain());
    const QString found = named<QPlainTextEdit>("Result of the swing")->toPlainText();
    EXPECT_TRUE(found.startsWith(QStringLiteral("▲ the needle is off")));
    EXPECT_TRUE(found.contains(QStringLiteral("No tilt: the boom was below 10°")));
    expectBlocked("Apply north", "a hopeless swing is not applied");
    EXPECT_EQ(named<ValueLabel>("Proposed calibration")->symbol(), Symbol::Warning);
    EXPECT_TRUE(text("What Apply changes").startsWith(samples::swungInVain().calibration->proposal->warnings.front()));
}

// Story: the tick beside the number 90 made it "-90".
// REQ-UI-1720: The numbers of the compass dial stand clear of its ticks.
TEST(CompassDial, TheNumbersStandClearOfTheTicks)
{
    CompassDial dial;
    dial.resize(240, 160);
    const QImage image = dial.grab().toImage();
    const QColor ground = image.pixelColor(0, 0);
    const int middle = image.height() / 2;
    const auto isEmpty = [&](int x) {
        for (int y = middle - 12; y < middle + 12; ++y) {
            if (image.pixelColor(x, y) != ground) {
                return false;
            }
        }
        return true;
    };
    int x = image.width() - 1;
    while (isEmpty(x)) {
        --x;
    }
    int longest = 0;
    for (int run = 0; x > image.width() / 2; --x) {
        run = isEmpty(x) ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    EXPECT_GE(longest, 4);
}

}  // namespace
}  // namespace boresight::ui

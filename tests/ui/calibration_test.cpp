// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_calibration.h"
#include "tests/ui/window_fixture.h"
#include "ui/body_page.h"
#include "ui/calibration_panel.h"
#include "ui/calibration_words.h"
#include "ui/choice_button.h"
#include "ui/command_button.h"
#include "ui/compass_dial.h"
#include "ui/deviation_plot.h"
#include "ui/jog_button.h"
#include "ui/jog_pad.h"
#include "ui/residual_sky.h"
#include "ui/sensor_levels.h"
#include "ui/sky_projection.h"
#include "ui/stop_button.h"
#include "ui/touch_combo.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>

namespace boresight::ui {
namespace {

class NorthTest : public WindowFixture
{
protected:
    QTabWidget& steps() { return *named<QTabWidget>("Steps of finding north"); }

    // By a click on its tab.
    void open(CalibrationStep step)
    {
        openPanel('9');
        QTabBar* const bar = steps().tabBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(static_cast<int>(step)).center());
    }
    void show(CalibrationStep step, const StationStatus& status)
    {
        open(step);
        give(samples::update(status));
    }
    void click(const char* name) { QTest::mouseClick(named<CommandButton>(name), Qt::LeftButton); }
    void choose(const char* name) { QTest::mouseClick(named<ChoiceButton>(name), Qt::LeftButton); }
    void chooseFile(const QString& path)
    {
        auto* const dialog = window.findChild<QFileDialog*>();
        ASSERT_NE(dialog, nullptr);
        auto* const name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
    }
    JogPad& nudgePad() { return *named<JogPad>("Nudge pad"); }

    template <class R>
    std::vector<R> wanted() const
    {
        std::vector<R> found;
        for (const CalibrationRequest& request : asked<CalibrationRequest>()) {
            if (const auto* const one = std::get_if<R>(&request)) {
                found.push_back(*one);
            }
        }
        return found;
    }
    // Disabled, and the tooltip says why.
    void expectBlocked(const char* button, const char* reason)
    {
        EXPECT_FALSE(named<CommandButton>(button)->isEnabled()) << button;
        EXPECT_TRUE(named<CommandButton>(button)->toolTip().contains(QString::fromUtf8(reason)))
            << named<CommandButton>(button)->toolTip().toStdString();
    }
};

TEST_F(NorthTest, IsReachedByItsKeyAndHasFiveNumberedSteps)
{
    openPanel('9');
    EXPECT_TRUE(window.findChild<CalibrationPanel*>()->isVisible());
    ASSERT_EQ(steps().count(), 5);
    for (int step = 0; step < 5; ++step) {
        EXPECT_TRUE(steps().tabText(step).startsWith(QString::number(step + 1))) << step;
        EXPECT_FALSE(steps().tabToolTip(step).isEmpty());
    }
    EXPECT_TRUE(requests.empty()) << "looking sends nothing";
}

TEST_F(NorthTest, TheQuestionAboutATurnTakesItsPlaceAndItsKeyWhileItIsOpen)
{
    openPanel('9');
    auto* const panel = window.findChild<CalibrationPanel*>();
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    EXPECT_FALSE(panel->isVisible());
    openPanel('9');
    EXPECT_FALSE(panel->isVisible());
    give(samples::update(samples::idle()));
    openPanel('9');
    EXPECT_TRUE(panel->isVisible());
}

TEST_F(NorthTest, StopWorksInEveryStepAndIsNotCovered)
{
    auto* const stop = window.findChild<StopButton*>();
    std::size_t stops = 0;
    for (const auto status : {samples::swinging, samples::followingSun, samples::sixPoints}) {
        for (int step = 0; step < 5; ++step) {
            show(static_cast<CalibrationStep>(step), status());
            EXPECT_EQ(window.size(), QSize(1024, 700)) << step;
            EXPECT_EQ(window.childAt(stop->mapTo(&window, stop->rect().center())), stop) << step;
            QTest::mousePress(stop, Qt::LeftButton);
            EXPECT_EQ(asked<request::Stop>().size(), ++stops);
            QTest::mouseRelease(stop, Qt::LeftButton);
            QTest::keyClick(&window, Qt::Key_Escape);
            EXPECT_EQ(asked<request::Stop>().size(), ++stops);
        }
    }
}

TEST_F(NorthTest, WithoutACalibrationDeskNothingIsOffered)
{
    StationStatus status = samples::idle();
    status.calibration = nullptr;
    for (int step = 0; step < 5; ++step) {
        show(static_cast<CalibrationStep>(step), status);
    }
    expectBlocked("Apply north", "nothing is proposed yet");
    expectBlocked("Undo the calibration", "nothing applied here");
    expectBlocked("Follow Sun", "it is not known where the Sun is");
}

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
    EXPECT_EQ(text("Sensor less axis"), QStringLiteral("+37.40°"));
    EXPECT_EQ(named<LevelBar>("Gyro calibration")->level(), 3);
    EXPECT_EQ(named<LevelBar>("Compass calibration")->level(), 0);
    EXPECT_EQ(text("Compass: what raises it"), QStringLiteral("figure of eight, away from iron"));
    EXPECT_EQ(named<ValueLabel>("Compass: what raises it")->symbol(), Symbol::Warning);
    EXPECT_EQ(text("Gyro: what raises it"), QStringLiteral("good"));
    status.sensor.presence = orientation::Presence::Lost;
    give(samples::update(status));
    EXPECT_FALSE(dial.sensor().has_value()) << "an old heading is not shown as a live one";
}

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

TEST_F(NorthTest, ARefusedSwingSaysWhyBesideItsButtonAndKeepsWhatWasTyped)
{
    show(CalibrationStep::Swing, samples::sixPoints());
    named<QDoubleSpinBox>("Rate of the swing")->setValue(2.0);
    click("Start swing");
    give(samples::refusal(samples::sixPoints(), requests.back().id, "the range is too small for a swing"));
    const auto* const panel = named<QTabWidget>("Steps of finding north")->currentWidget();
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
    expectBlocked("Average", "a calibration is running");
    expectBlocked("Follow Sun", "a calibration is running");
}

TEST_F(NorthTest, TheDeviationCurveLiesWhereItsSamplesAreAndShowsBothWays)
{
    const StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    QTest::qWait(1);
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
            EXPECT_LE(abs(one.error).degrees(), plot.limit());
        }
    }
    const QString found = named<QPlainTextEdit>("What the swing has found")->toPlainText();
    EXPECT_TRUE(found.startsWith(QStringLiteral("North ")));
    EXPECT_TRUE(found.contains(QStringLiteral("leans by 0.60° ± 0.05°")));
}

TEST_F(NorthTest, AHopelessPlaceIsSaidFirstAndNothingOfItCanBeApplied)
{
    show(CalibrationStep::Swing, samples::swungInVain());
    const QString found = named<QPlainTextEdit>("What the swing has found")->toPlainText();
    EXPECT_TRUE(found.startsWith(QStringLiteral("▲ the needle is off")));
    EXPECT_TRUE(found.contains(QStringLiteral("No tilt: the boom was below 10°")));
    expectBlocked("Apply north", "a hopeless swing is not applied");
    EXPECT_EQ(named<ValueLabel>("Proposed calibration")->symbol(), Symbol::Warning);
}

TEST_F(NorthTest, AsLongAsTheSunIsMeantTheWarningStandsThere)
{
    show(CalibrationStep::Body, samples::beforeCalibration());
    EXPECT_EQ(text("Eyes and feed"), sunWarning());
    choose("Points by the Moon");
    EXPECT_TRUE(text("Eyes and feed").isEmpty());
    give(samples::update(samples::followingSun()));
    EXPECT_TRUE(text("Eyes and feed").startsWith(QLatin1String("The beam looks into the Sun")))
        << "while the beam is there, whatever is looked at";
    choose("Points by the Sun");
    EXPECT_FALSE(text("Eyes and feed").isEmpty());
}

TEST_F(NorthTest, SunAndMoonAreFollowedWithTheRefractionChosen)
{
    show(CalibrationStep::Body, samples::sixPoints());
    EXPECT_TRUE(text("Where the body is").startsWith(QStringLiteral("az 143.2°  el 52.1°, sets 20:39Z")));
    auto* const refraction = named<TouchCombo>("Refraction");
    refraction->setFocus();
    QTest::keyClick(refraction, Qt::Key_Down);
    click("Follow Sun");
    ASSERT_EQ(wanted<request::FollowBody>().size(), 1u);
    EXPECT_EQ(wanted<request::FollowBody>().front().body, ephemeris::Body::Sun);
    EXPECT_EQ(wanted<request::FollowBody>().front().refraction, ephemeris::Refraction::Radio);
    choose("Points by the Moon");
    EXPECT_TRUE(text("Where the body is").contains(QLatin1String("below the horizon, rises 22:43Z")));
    expectBlocked("Follow Moon", "below the lowest elevation");
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
    EXPECT_TRUE(text("Where the body is").contains(QLatin1String("points taken: 3")));
    click("Hold, follow the Sun no more");
    EXPECT_EQ(asked<request::Hold>().size(), 1u);
}

TEST_F(NorthTest, APointCanNotBeTakenBeforeTheBodyIsFollowed)
{
    show(CalibrationStep::Body, samples::beforeCalibration());
    expectBlocked("Take point", "follow the Sun first");
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
    click("Take the landmark as a point");
    ASSERT_EQ(wanted<request::TakeKnownPoint>().size(), 1u);
    const auto taken = wanted<request::TakeKnownPoint>().front();
    EXPECT_NEAR(taken.truth.azimuth.degrees(), 271.25, 1e-9);
    EXPECT_NEAR(taken.truth.elevation.degrees(), 1.5, 1e-9);
    EXPECT_EQ(taken.label, QStringLiteral("church tower"));
}

TEST_F(NorthTest, TheScanWaitsForTypedPowersAndTakesNumbersOnly)
{
    show(CalibrationStep::Body, samples::followingSun());
    choose("The peak of the received power, by a cross scan");
    expectBlocked("Give dB", "no scan waits");
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

TEST_F(NorthTest, TheScanTellsWhatTheReceiverSays)
{
    StationStatus status = samples::followingSun();
    show(CalibrationStep::Body, status);
    choose("The peak of the received power, by a cross scan");
    EXPECT_TRUE(text("Power of the receiver").isEmpty()) << "the profile names none";
    const auto tell = [&](const power::LineStatus& line) {
        CalibrationStatus calibration = *status.calibration;
        calibration.powerLine = line;
        status.calibration = std::make_shared<const CalibrationStatus>(calibration);
        give(samples::update(status));
    };
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540")});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("UDP 127.0.0.1:4540: nothing has come yet"));
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540"), .decibels = -73.25, .age = Seconds(2.2)});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("UDP 127.0.0.1:4540: -73.3 dB, 2 s old"));
    tell({.name = QStringLiteral("UDP 127.0.0.1:4540"),
          .problem = QStringLiteral("nothing comes"),
          .decibels = -73.25,
          .age = Seconds(9.0)});
    EXPECT_EQ(text("Power of the receiver"), QStringLiteral("nothing comes"));
    EXPECT_EQ(named<ValueLabel>("Power of the receiver")->symbol(), Symbol::Warning);
}

TEST_F(NorthTest, TermsAreTypedAndProposed)
{
    const StationStatus status = samples::sixPoints();
    show(CalibrationStep::Model, status);
    choose("Type the terms, or exchange them with a file");
    auto* const north = named<QDoubleSpinBox>("azimuth offset");
    EXPECT_NEAR(north->value(), status.calibration->present.azimuthOffset.degrees(), 1e-4);
    EXPECT_EQ(north->maximum(), 360.0) << "as the profile's own";
    north->setFocus();
    north->selectAll();
    QTest::keyClicks(north, QStringLiteral("-12.5"));
    EXPECT_TRUE(requests.empty()) << "typing sends nothing";
    give(samples::update(status));
    EXPECT_NEAR(north->value(), -12.5, 1e-9) << "a new status does not type over it";
    click("Propose the typed terms");
    ASSERT_EQ(wanted<request::ProposeTerms>().size(), 1u);
    pointing::PointingTerms expected = status.calibration->present;
    expected.azimuthOffset = Angle::fromDegrees(-12.5);
    EXPECT_EQ(wanted<request::ProposeTerms>().front().terms, expected) << "what was not typed keeps all its decimals";
    EXPECT_FALSE(named<QTableView>("Terms of the pointing model")->isVisible());
    give(samples::acceptance(status, requests.back().id));
    EXPECT_TRUE(named<QTableView>("Terms of the pointing model")->isVisible()) << "beside those in force";
    choose("Type the terms, or exchange them with a file");
    click("Terms in force again");
    EXPECT_NEAR(north->value(), status.calibration->present.azimuthOffset.degrees(), 1e-4);
}

TEST_F(NorthTest, WhatIsTypedIsShownWithWhatThePointsSayOfIt)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal->title = QStringLiteral("Typed terms");
    calibration.proposal->reason = QStringLiteral("typed");
    calibration.proposal->residuals = ProposalResiduals{.before = 0.912_deg, .after = 0.5_deg, .points = 5};
    calibration.proposal->terms.at(0).sigma.reset();
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    EXPECT_EQ(text("Proposed calibration"), QStringLiteral("Typed terms, points: rms 0.912° → 0.500°"));
    const QAbstractItemModel& terms = *named<QTableView>("Terms of the pointing model")->model();
    EXPECT_EQ(terms.data(terms.index(0, 4)).toString(), QStringLiteral("● given"));
    calibration.proposal->warnings = {QStringLiteral("the text is of another mount"), QStringLiteral("and site")};
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    give(samples::update(status));
    EXPECT_TRUE(named<QPlainTextEdit>("Remarks on the fit")
                    ->toPlainText()
                    .startsWith(QStringLiteral("the text is of another mount\nand site\n")));
}

TEST_F(NorthTest, TermsAreExchangedWithAFile)
{
    const QTemporaryDir folder;
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.sheet = {.mountName = "Roof", .terms = calibration.present};
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    choose("Type the terms, or exchange them with a file");
    click("Export terms");
    chooseFile(folder.filePath(QStringLiteral("roof")));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window.findChild<QFileDialog*>() == nullptr; }));
    QFile file(folder.filePath(QStringLiteral("roof.txt")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << "the suffix is that of the filter";
    const std::string written = file.readAll().toStdString();
    EXPECT_EQ(written, calibration::toText(calibration.sheet));
    EXPECT_TRUE(requests.empty()) << "an export changes nothing";
    click("Import terms");
    chooseFile(file.fileName());
    ASSERT_EQ(wanted<request::ImportTerms>().size(), 1u);
    EXPECT_EQ(wanted<request::ImportTerms>().front().name, QStringLiteral("roof.txt"));
    EXPECT_EQ(wanted<request::ImportTerms>().front().text, written);
}

TEST_F(NorthTest, TermsAreNotTakenWhileACalibrationRuns)
{
    show(CalibrationStep::Model, samples::scanning());
    choose("Type the terms, or exchange them with a file");
    expectBlocked("Propose the typed terms", "a calibration is running");
    expectBlocked("Import terms", "a calibration is running");
    EXPECT_TRUE(named<CommandButton>("Export terms")->isEnabled());
}

TEST_F(NorthTest, TheModelShowsEachTermInForceAndProposed)
{
    show(CalibrationStep::Model, samples::sixPoints());
    const QAbstractItemModel& terms = *named<QTableView>("Terms of the pointing model")->model();
    ASSERT_EQ(terms.rowCount(), 7);
    const auto cell = [&](int row, int column) { return terms.data(terms.index(row, column)).toString(); };
    EXPECT_EQ(cell(0, 0), QStringLiteral("azimuth offset"));
    EXPECT_EQ(cell(0, 1), QStringLiteral("36.100°"));
    EXPECT_EQ(cell(0, 2), QStringLiteral("37.412°"));
    EXPECT_EQ(cell(0, 3), QStringLiteral("± 0.021°"));
    EXPECT_EQ(cell(0, 4), QStringLiteral("● found"));
    EXPECT_EQ(cell(6, 4), QStringLiteral("as it was"));
    EXPECT_TRUE(
        text("How well the model fits").startsWith(QStringLiteral("5 of 6 points, 5 terms: rms 0.912° → 0.031°")));
}

TEST_F(NorthTest, APointIsLeftOutUsedAgainAndDropped)
{
    show(CalibrationStep::Model, samples::sixPoints());
    choose("The points, and how far each is off");
    expectBlocked("Leave out", "select a point first");
    auto* const table = named<QTableView>("Calibration points");
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(1, 0)).center());
    click("Leave out");
    ASSERT_EQ(wanted<request::UsePoint>().size(), 1u);
    EXPECT_EQ(wanted<request::UsePoint>().front().index, 1u);
    EXPECT_FALSE(wanted<request::UsePoint>().front().used);
    QTest::keyClick(table, Qt::Key_Down);
    QTest::keyClick(table, Qt::Key_Down);
    give(samples::update(samples::sixPoints()));
    click("Use again");
    EXPECT_EQ(wanted<request::UsePoint>().back().index, 3u);
    EXPECT_TRUE(wanted<request::UsePoint>().back().used);
    click("Drop the selected point");
    ASSERT_EQ(wanted<request::DropPoint>().size(), 1u);
    EXPECT_EQ(wanted<request::DropPoint>().front().index, 3u);
}

TEST_F(NorthTest, TheArrowsOfTheResidualsPointWhereTheBeamLooks)
{
    show(CalibrationStep::Model, samples::sixPoints());
    choose("The points, and how far each is off");
    QTest::qWait(1);
    const auto& sky = *window.findChild<ResidualSky*>();
    PointStatus point;
    point.truth = {180_deg, 45_deg};
    point.before = {.across = 0.5_deg, .elevation = 0_deg};
    const QPointF at = sky.sky().toPixel(point.truth);
    EXPECT_LT(sky.tip(point, false).x(), at.x() - 5.0) << "clockwise in the south is to the west, on the left";
    EXPECT_NEAR(sky.tip(point, false).y(), at.y(), 1e-6);
    point.before = {.across = 0_deg, .elevation = 0.5_deg};
    EXPECT_LT(sky.tip(point, false).y(), at.y() - 5.0) << "higher is nearer to the zenith";
}

TEST_F(NorthTest, ApplySendsTheProposalThatWasSeenWhenItWasPressed)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    auto* const apply = named<CommandButton>("Apply north");
    EXPECT_TRUE(text("What Apply changes").startsWith(QStringLiteral("azimuth offset 0.00° → 3")));
    EXPECT_TRUE(apply->toolTip().contains(text("What Apply changes")));
    QTest::mousePress(apply, Qt::LeftButton);
    CalibrationStatus newer = *status.calibration;
    newer.proposal->number = 8;
    status.calibration = std::make_shared<const CalibrationStatus>(newer);
    give(samples::update(status));
    QTest::mouseRelease(apply, Qt::LeftButton);
    ASSERT_EQ(wanted<request::ApplyCalibration>().size(), 1u);
    EXPECT_EQ(wanted<request::ApplyCalibration>().front().proposal, 7u);
    apply->setFocus();
    QTest::keyClick(apply, Qt::Key_Space);
    EXPECT_EQ(wanted<request::ApplyCalibration>().back().proposal, 8u);
}

TEST_F(NorthTest, UndoAndRedoAreOfferedWhereThereIsSomethingAndTheHistoryWarnsOfAnotherMount)
{
    StationStatus status = samples::sixPoints();
    show(CalibrationStep::History, status);
    EXPECT_EQ(text("Calibration in force"), QStringLiteral("In force: North from the compass swing"));
    click("Undo the calibration");
    EXPECT_EQ(wanted<request::UndoCalibration>().size(), 1u);
    expectBlocked("Redo the calibration", "nothing was taken back");
    auto* const table = named<QTableView>("Calibrations that were applied");
    ASSERT_EQ(table->model()->rowCount(), 2);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(1, 1)).center());
    EXPECT_TRUE(named<QPlainTextEdit>("The selected calibration")->toPlainText().contains(QStringLiteral("▲ Braga")));
    CalibrationStatus undone = *status.calibration;
    undone.canRedo = true;
    std::swap(undone.history.front().inForce, undone.history.back().inForce);
    status.calibration = std::make_shared<const CalibrationStatus>(undone);
    give(samples::update(status));
    EXPECT_TRUE(text("Calibration in force").contains(QLatin1String("other drives or elsewhere")));
    click("Redo the calibration");
    EXPECT_EQ(wanted<request::RedoCalibration>().size(), 1u);
}

TEST_F(NorthTest, EveryControlHasANameAndIsReachedByTheTabKey)
{
    for (int step = 0; step < 5; ++step) {
        show(static_cast<CalibrationStep>(step), samples::sixPoints());
        const QWidget* const page = steps().currentWidget();
        std::vector<const QWidget*> missing;
        for (const QWidget* const widget : page->findChildren<QWidget*>()) {
            // Of exclusive choices one stands for all: the arrows go on to the others.
            const auto* const choice = qobject_cast<const QAbstractButton*>(widget);
            const bool byArrows = choice != nullptr && choice->group() != nullptr && !choice->isChecked();
            if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
                widget->focusProxy() == nullptr && !byArrows) {
                EXPECT_FALSE(widget->accessibleName().isEmpty())
                    << widget->metaObject()->className() << " in step " << step + 1;
                missing.push_back(widget);
            }
        }
        steps().tabBar()->setFocus();
        for (int press = 0; press < 40 && !missing.empty(); ++press) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            std::erase(missing, QApplication::focusWidget());
        }
        for (const QWidget* const widget : missing) {
            ADD_FAILURE() << widget->accessibleName().toStdString() << " is not reached in step " << step + 1;
        }
    }
    EXPECT_TRUE(requests.empty());
}

}  // namespace
}  // namespace boresight::ui

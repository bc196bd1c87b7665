// SPDX-License-Identifier: GPL-3.0-or-later
// The pages Sensor, Swing and History of the panel North: what is shown while the mount turns, and how accurate the
// results are.
#include "tests/ui/sample_calibration.h"
#include "tests/ui/window_fixture.h"
#include "ui/north/calibration_panel.h"
#include "ui/north/deviation_plot.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>

#include <algorithm>

namespace boresight::ui {
namespace {

class NorthPagesTest : public WindowFixture
{
protected:
    void show(CalibrationStep step, const StationStatus& status)
    {
        openPanel('9');
        window.findChild<CalibrationPanel*>()->go(step);
        give(samples::update(status));
        settle();
    }
    bool offers(const QString& words)
    {
        const auto buttons = window.findChildren<QPushButton*>();
        return std::ranges::any_of(buttons, [&](QPushButton* one) { return one->isVisible() && one->text() == words; });
    }
    QString found() { return named<QPlainTextEdit>("Result of the swing")->toPlainText(); }
};

// The number of dots with something painted at their place.
int painted(DeviationPlot& plot, const std::vector<calibration::SwingDot>& dots)
{
    QImage image(plot.size(), QImage::Format_RGB32);
    plot.render(&image);
    int count = 0;
    for (const calibration::SwingDot& dot : dots) {
        count += image.pixelColor(plot.pixel(dot.heading, dot.error).toPoint()) != currentTheme().plotGround ? 1 : 0;
    }
    return count;
}

TEST_F(NorthPagesTest, TheReadingsOfASwingAreDrawnAsTheyCome)
{
    const StationStatus status = samples::swinging();
    const auto dots = status.calibration->swingSoFar;
    ASSERT_GT(dots.size(), 50U);
    show(CalibrationStep::Swing, status);
    auto& plot = *window.findChild<DeviationPlot*>();
    EXPECT_GT(painted(plot, dots), static_cast<int>(dots.size() * 9 / 10));
    EXPECT_TRUE(found().startsWith(QStringLiteral("Readings around their mean"))) << found().toStdString();
    EXPECT_LE(plot.lowest(), -10.0);
    EXPECT_GE(plot.highest(), 10.0) << "the first readings lie within a degree: the scale does not jump";

    StationStatus begun = status;
    CalibrationStatus calibration = *status.calibration;
    calibration.swingSoFar.clear();
    begun.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Swing, begun);
    EXPECT_LT(painted(plot, dots), static_cast<int>(dots.size() / 4)) << "but the grid, nothing lies there now";
}

// Story: a curve from -11° to 8° was drawn between -20° and 20°, below black dots, and the scatter was not visible.
TEST_F(NorthPagesTest, TheCurveFillsThePlotAndIsSeenAmongItsReadings)
{
    const StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    auto& plot = *window.findChild<DeviationPlot*>();
    const calibration::CompassSwing& fit = status.calibration->swing->fit;
    double least = 0.0;
    double most = 0.0;
    for (const calibration::SwingResidual& one : fit.samples) {
        const bool used = one.fate == calibration::SampleFate::Used;
        least = std::min(least, used ? one.error.degrees() : 0.0);
        most = std::max(most, used ? one.error.degrees() : 0.0);
    }
    EXPECT_LE(plot.lowest(), least);
    EXPECT_GE(plot.highest(), most);
    EXPECT_GT(most - least, 0.6 * (plot.highest() - plot.lowest()));
    QImage image(plot.size(), QImage::Format_RGB32);
    plot.render(&image);
    int onCurve = 0;
    int black = 0;
    for (int heading = 5; heading < 360; heading += 5) {
        const QPoint at =
            plot.pixel(Angle::fromDegrees(heading), fit.curve.deviation(Angle::fromDegrees(heading))).toPoint();
        const auto is = [&](int above, const QColor& colour) {
            return image.valid(at.x(), at.y() - above) && image.pixelColor(at.x(), at.y() - above) == colour;
        };
        onCurve += is(0, currentTheme().accent) || is(1, currentTheme().accent) ? 1 : 0;
        for (int above = -5; above <= 5; ++above) {
            black += is(above, currentTheme().text) ? 1 : 0;
        }
    }
    EXPECT_GT(onCurve, 60) << "of 71";
    EXPECT_EQ(0, black) << "dots hide nothing";
}

// The dots may be thinned. The text counts all readings, like the line of the run.
TEST_F(NorthPagesTest, ThePlotTellsAsManyReadingsAsTheRun)
{
    StationStatus status = samples::swinging();
    CalibrationStatus calibration = *status.calibration;
    for (const int readings : {1399, 1400}) {  // the dots stay the same
        calibration.progress.text = QStringLiteral("turning clockwise, readings: %1").arg(readings);
        status.calibration = std::make_shared<const CalibrationStatus>(calibration);
        show(CalibrationStep::Swing, status);
        EXPECT_EQ(calibration.progress.text, window.findChild<DeviationPlot*>()->accessibleDescription());
    }
}

// The scroll position stays, and a screen reader does not get the same text ten times a second.
TEST_F(NorthPagesTest, WhatIsSaidWhileItTurnsIsSaidOnce)
{
    show(CalibrationStep::Swing, samples::swinging());
    const QSignalSpy said(named<QPlainTextEdit>("Result of the swing"), &QPlainTextEdit::textChanged);
    show(CalibrationStep::Swing, samples::swinging());
    EXPECT_EQ(0, said.count());
}

// The curve of the previous swing would be taken for the new one. It is shown again if the new swing gives no result.
TEST_F(NorthPagesTest, TheCurveOfBeforeIsNotSeenWhileTheMountTurns)
{
    const StationStatus before = samples::swung();
    show(CalibrationStep::Swing, before);
    const QString whole = found();
    ASSERT_TRUE(whole.startsWith(QStringLiteral("North ")));
    StationStatus turning = samples::swinging();
    CalibrationStatus calibration = *turning.calibration;
    calibration.swing = before.calibration->swing;
    turning.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Swing, turning);
    EXPECT_FALSE(found().contains(QStringLiteral("North ")));
    show(CalibrationStep::Swing, before);
    EXPECT_EQ(whole, found());
}

// Story: ten points gave north to 0.11°. The curve of a swing could only be applied together with the north of the
// swing, which is known to only 2.39°.
TEST_F(NorthPagesTest, ACurveThatLeavesNorthIsAppliedToTheSensor)
{
    StationStatus status = samples::swung();
    show(CalibrationStep::Swing, status);
    EXPECT_TRUE(offers(QStringLiteral("Apply north")));
    CalibrationStatus calibration = *status.calibration;
    ASSERT_TRUE(calibration.proposal);
    calibration.proposal->changesSensor = true;
    for (TermStatus& term : calibration.proposal->terms) {
        term.proposed = term.present;
    }
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Swing, status);
    EXPECT_TRUE(offers(QStringLiteral("Apply to sensor")));
    EXPECT_EQ(QStringLiteral("north stays, curve of the sensor"), text("What Apply changes"));
}

TEST_F(NorthPagesTest, TheSensorsAzimuthIsToldWithHowWellItIsKnown)
{
    StationStatus status = samples::heard();
    show(CalibrationStep::Sensor, status);
    EXPECT_EQ(QStringLiteral("58.1° ± 1.7°"), text("True azimuth from the sensor and its uncertainty"));
    status.sensor.azimuthSigma.reset();
    show(CalibrationStep::Sensor, status);
    EXPECT_EQ(QStringLiteral("58.1°"), text("True azimuth from the sensor and its uncertainty"));
    status.sensor.direction.reset();
    show(CalibrationStep::Sensor, status);
    EXPECT_FALSE(text("True azimuth from the sensor and its uncertainty").contains(QStringLiteral("58")));
}

// Story: "North: axis +39.93° ± 6.02°" was shown long after ten points of the Sun were in effect.
TEST_F(NorthPagesTest, AnAverageIsToldBesideWhatIsInForce)
{
    StationStatus status = samples::heard();
    CalibrationStatus calibration = *status.calibration;
    calibration.sensorOffset.emplace();
    calibration.sensorOffset->offset = {39.93_deg, 6.02_deg};
    calibration.present.azimuthOffset = 37.5_deg;
    calibration.sheet.sigmas[0] = 0.11_deg;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Sensor, status);
    EXPECT_EQ(QStringLiteral("Last average: axis +39.93° ± 6.02°, in force +37.50° ± 0.11°"),
              text("North from the sensor"));
    calibration.sheet.sigmas[0].reset();
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Sensor, status);
    EXPECT_TRUE(text("North from the sensor").endsWith(QStringLiteral("in force +37.50°")));
}

TEST_F(NorthPagesTest, AModelIsNotCheckedByASensorThatKnowsLess)
{
    StationStatus status = samples::sixPoints();
    status.sensor.azimuthSigma = 1.7_deg;
    show(CalibrationStep::Model, status);
    EXPECT_TRUE(named<QPlainTextEdit>("Remarks on the fit")
                    ->toPlainText()
                    .contains(QStringLiteral("to 1.7° here (1 sigma). It cannot check a more exact model")));
}

TEST_F(NorthPagesTest, TheDeclinationIsToldWithItsModelAndWhatIsWrongWithIt)
{
    StationStatus status = samples::heard();
    show(CalibrationStep::Sensor, status);
    ValueLabel& line = *named<ValueLabel>("Where the declination is applied");
    EXPECT_TRUE(line.text().endsWith(QStringLiteral("(WMM-2025, 2025.0 to 2030.0)"))) << line.text().toStdString();
    EXPECT_EQ(Tone::Secondary, line.tone());
    EXPECT_FALSE(line.isElided());
    status.sensor.declinationDoubt =
        QStringLiteral("The magnetic model WMM-2025 is valid until 2030.00. Get the next model before then.");
    show(CalibrationStep::Sensor, status);
    EXPECT_TRUE(line.text().contains(QStringLiteral("valid until 2030")));
    EXPECT_EQ(Tone::Warning, line.tone());
}

TEST_F(NorthPagesTest, ItsSettingsAreAPressAway)
{
    show(CalibrationStep::Sensor, samples::heard());
    QTest::mouseClick(named<QPushButton>("Change the declination"), Qt::LeftButton);
    auto& search = *named<QLineEdit>("Search the settings");
    EXPECT_TRUE(search.isVisible()) << "the page Profile is in front";
    EXPECT_EQ(QStringLiteral("declination"), search.text());
}

TEST_F(NorthPagesTest, WhatWasTakenBackAndReplacedIsToldAsSuch)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.history[1].superseded = true;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::History, status);
    auto& table = *named<QTableView>("Calibrations that were applied");
    EXPECT_TRUE(table.model()->index(1, 1).data().toString().endsWith(QStringLiteral("(undone)")));
    table.selectRow(1);
    EXPECT_TRUE(named<QPlainTextEdit>("The selected calibration")
                    ->toPlainText()
                    .contains(QStringLiteral("another calibration was applied later")));
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/north/north_fixture.h"
#include "ui/north/residual_sky.h"
#include "ui/sky/sky_projection.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTemporaryDir>

// The terms of the model, typed, fitted and exchanged, and its points: step 4 of finding north.
namespace boresight::ui {
namespace {

// REQ-UI-40a: Terms are typed, or exchanged with a file, like any other result: they are proposed beside the terms in
// effect, with the residuals of the points. A term without typing keeps all its decimals. The scan shows the last value
// of the receiver, its age, and a problem of its line.
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

// REQ-UI-40a
TEST_F(NorthTest, WhatIsTypedIsShownWithWhatThePointsSayOfIt)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal->title = QStringLiteral("Typed terms");
    calibration.proposal->reason = QStringLiteral("typed");
    calibration.proposal->residuals = ProposalResiduals{.before = 0.912_deg, .after = 0.5_deg, .points = 5};
    calibration.proposal->terms.at(0).sigma.reset();
    calibration.proposal->terms.at(0).proposed = 40_deg;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    EXPECT_EQ(text("Proposed calibration"), QStringLiteral("Typed terms, points: rms 0.912° → 0.500°"));
    const QAbstractItemModel& terms = *named<QTableView>("Terms of the pointing model")->model();
    EXPECT_EQ(terms.data(terms.index(0, 4)).toString(), QStringLiteral("● typed"));
    calibration.proposal->warnings = {QStringLiteral("The text belongs to another mount"), QStringLiteral("and site")};
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    give(samples::update(status));
    EXPECT_TRUE(named<QPlainTextEdit>("Remarks on the fit")
                    ->toPlainText()
                    .startsWith(QStringLiteral("The text belongs to another mount\nand site\n")));
}

// Story: a fit has more decimals than the field. A term that was stepped up and down again counted as entered, and lost
// decimals.
// REQ-UI-40a
TEST_F(NorthTest, WhatReadsTheSameWasNotTyped)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.present.azimuthOffset = Angle::fromDegrees(38.111139342);
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    choose("Type the terms, or exchange them with a file");
    named<QDoubleSpinBox>("azimuth offset")->stepUp();
    named<QDoubleSpinBox>("azimuth offset")->stepDown();
    named<QDoubleSpinBox>("collimation")->setValue(0.3);
    click("Propose the typed terms");
    pointing::PointingTerms expected = calibration.present;
    expected.collimation = 0.3_deg;
    ASSERT_EQ(wanted<request::ProposeTerms>().size(), 1u);
    EXPECT_EQ(wanted<request::ProposeTerms>().front().terms, expected);
    // Applied and then undone: the field shows the value in effect again.
    calibration.present.collimation = 0.3_deg;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    named<QDoubleSpinBox>("azimuth offset")->setFocus();
    give(samples::update(status));
    calibration.present.collimation = 0_deg;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    give(samples::update(status));
    EXPECT_EQ(named<QDoubleSpinBox>("collimation")->value(), 0.0);
}

// Story: a filled column "Proposed" was beside "Nothing proposed yet".
TEST_F(NorthTest, NothingIsShownAsProposedThatIsNot)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal.reset();
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    const QAbstractItemModel& terms = *named<QTableView>("Terms of the pointing model")->model();
    ASSERT_EQ(terms.rowCount(), 7);
    for (int row = 0; row < terms.rowCount(); ++row) {
        for (int column = 2; column < terms.columnCount(); ++column) {
            EXPECT_EQ(terms.data(terms.index(row, column)).toString(), QString()) << row << ' ' << column;
        }
    }
    EXPECT_TRUE(text("How well the model fits")
                    .startsWith(QStringLiteral(
                        "5 of 6 points: rms now 0.912°, with the best fit of these points 0.031° (5 terms)")))
        << text("How well the model fits").toStdString();
}

// Story: terms were typed, and the header still showed the rms of the fit as if it was theirs.
TEST_F(NorthTest, TheRmsIsThatOfWhatIsProposed)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal->reason = QStringLiteral("typed");
    calibration.proposal->terms.at(0).proposed = 40_deg;
    calibration.proposal->residuals = ProposalResiduals{.before = 0.912_deg, .after = 0.5_deg, .points = 5};
    calibration.fit->reducedChiSquare = 0.0123;
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    const QString told = text("How well the model fits");
    EXPECT_TRUE(told.startsWith(QStringLiteral(
        "5 of 6 points: rms now 0.912°, with the proposal 0.500°, with the best fit of these points 0.031° (5 terms)")))
        << told.toStdString();
    EXPECT_TRUE(told.endsWith(QStringLiteral("χ² 0.012"))) << told.toStdString();
}

// Story: six stored points waited for a drive, and only "No fit for these points" was shown.
// REQ-NORTH-38i
TEST_F(NorthTest, WhyThereIsNoFitIsSaid)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    calibration.proposal.reset();
    calibration.fit.reset();
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    EXPECT_EQ(text("How well the model fits"), QStringLiteral("No fit for these points"));
    calibration.noFit = QStringLiteral("they wait");
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    give(samples::update(status));
    EXPECT_EQ(text("How well the model fits"), QStringLiteral("No fit: they wait"));
}

// Story: terms that the points only changed within earlier knowledge were called "found".
TEST_F(NorthTest, WhatIsOnlyHeldIsSaidSo)
{
    StationStatus status = samples::sixPoints();
    CalibrationStatus calibration = *status.calibration;
    for (auto* const terms : {&calibration.proposal->terms, &calibration.fit->terms}) {
        TermStatus& sag = terms->at(6);
        sag.proposed = Angle::fromDegrees(-0.001);
        sag.sigma = 0.1_deg;
        sag.isOn = false;
    }
    status.calibration = std::make_shared<const CalibrationStatus>(calibration);
    show(CalibrationStep::Model, status);
    const QAbstractItemModel& terms = *named<QTableView>("Terms of the pointing model")->model();
    EXPECT_EQ(terms.data(terms.index(0, 4)).toString(), QStringLiteral("● found"));
    EXPECT_EQ(terms.data(terms.index(5, 4)).toString(), QStringLiteral("unchanged"));
    EXPECT_EQ(terms.data(terms.index(6, 4)).toString(), QStringLiteral("◐ held"));
}

// Story: a point of the Sun counts eleven times as much as a landmark, and this was not visible.
TEST_F(NorthTest, APointShowsItsSigma)
{
    show(CalibrationStep::Model, samples::sixPoints());
    choose("The points and their residuals");
    const QAbstractItemModel& points = *named<QTableView>("Calibration points")->model();
    EXPECT_EQ(points.headerData(2, Qt::Horizontal).toString(), QStringLiteral("Sigma"));
    EXPECT_EQ(points.data(points.index(0, 2)).toString(), QStringLiteral("0.05°"));
    EXPECT_EQ(points.data(points.index(3, 0)).toString(), QStringLiteral("○ church tower"));
    EXPECT_TRUE(points.data(points.index(3, 0), Qt::ToolTipRole).toString().contains(QStringLiteral("not used")));
}

// REQ-UI-40a
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
    ASSERT_TRUE(comesTrue([this] { return window.findChild<QFileDialog*>() == nullptr; }));
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
    expectBlocked("Propose the typed terms", "A calibration is running");
    expectBlocked("Import terms", "A calibration is running");
    EXPECT_TRUE(named<CommandButton>("Export terms")->isEnabled());
}

// REQ-UI-40
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
    EXPECT_EQ(cell(6, 4), QStringLiteral("unchanged"));
    EXPECT_TRUE(
        text("How well the model fits").startsWith(QStringLiteral("5 of 6 points, 5 terms: rms 0.912° → 0.031°")));
}

TEST_F(NorthTest, APointIsLeftOutUsedAgainAndDropped)
{
    show(CalibrationStep::Model, samples::sixPoints());
    choose("The points and their residuals");
    expectBlocked("Leave out", "Select a point first.");
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
    choose("The points and their residuals");
    settle();
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

}  // namespace
}  // namespace boresight::ui

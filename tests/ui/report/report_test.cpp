// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/recording/recorded_pass.h"
#include "ui/report/paper_text.h"
#include "ui/report/report_chart.h"
#include "ui/report/report_output.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace boresight::ui {
namespace {

using recording::Recording;

Recording recordedFor(std::size_t ticks, double azimuthOff = 0.0)
{
    Recording made{
        .header = recording::recordedHeader(), .ticks = recording::RecordedPass().ticks(ticks), .hasEnd = true};
    for (recording::Tick& tick : made.ticks) {
        tick.actual->azimuth += Angle::fromDegrees(azimuthOff);
    }
    made.events.push_back({.utc = made.ticks.empty() ? UtcTime{} : made.ticks.front().utc,
                           .kind = recording::EventKind::MotionStart,
                           .source = QStringLiteral("operator"),
                           .text = QStringLiteral("Track NOAA 19.")});
    return made;
}

// The number of pixels of this colour.
int pixelsOf(const QImage& picture, const QColor& colour)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            count += picture.pixel(x, y) == colour.rgb() ? 1 : 0;
        }
    }
    return count;
}

ReportPage pageFor(std::span<const Recording> recordings)
{
    const Result<ReportPage> page = reportPageOf(recordings);
    EXPECT_TRUE(page.has_value());
    return page.value_or(ReportPage{});
}

class ReportFileTest : public testing::Test
{
protected:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] static QByteArray read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
};

// REQ-REPORT-20: The report of a pass is one page, A4, as PDF, and the same page as PNG with 200 dots per inch.
TEST_F(ReportFileTest, IsOnePageAsPdfAndPng)
{
    const std::array passes{recordedFor(3000)};
    ASSERT_TRUE(writeReport(passes, path("pass.pdf")));
    const QByteArray pdf = read(path("pass.pdf"));
    EXPECT_TRUE(pdf.startsWith("%PDF-"));
    EXPECT_TRUE(pdf.contains("/Count 1\n"));
    EXPECT_TRUE(pdf.contains("/MediaBox [0 0 595"));
    ASSERT_TRUE(writeReport(passes, path("pass.PNG")));
    const QImage picture = QImage::fromData(read(path("pass.PNG")));
    EXPECT_EQ(picture.size(), QSize(1654, 2339));
    EXPECT_EQ(picture.dotsPerMeterX(), 7874);
    EXPECT_EQ(picture.pixel(3, 3), QColor(Qt::white).rgb());
    EXPECT_GT(pixelsOf(picture, kPassInk[0]), 500);
    EXPECT_EQ(pixelsOf(picture, kPassInk[1]), 0);
}

// REQ-REPORT-21: Two passes stand on one page, each in its colour.
TEST_F(ReportFileTest, TwoPassesHaveTwoColours)
{
    const std::array passes{recordedFor(2000), recordedFor(3000, 10.0)};
    const ReportPage page = pageFor(passes);
    ASSERT_EQ(page.traces.size(), 2U);
    EXPECT_EQ(page.table.back().values.size(), 2);
    const QImage picture = QImage::fromData(pngOf(page));
    EXPECT_GT(pixelsOf(picture, kPassInk[0]), 500);
    EXPECT_GT(pixelsOf(picture, kPassInk[1]), 500);
}

// REQ-REPORT-05
TEST_F(ReportFileTest, NamesWhatIsInTheWay)
{
    const auto errorOf = [](std::span<const Recording> recordings, const QString& file) {
        const Result<> written = writeReport(recordings, file);
        return written ? QString() : written.error().text;
    };
    const std::array passes{recordedFor(100), recordedFor(0), recordedFor(100)};
    EXPECT_EQ(errorOf(std::span(passes).first(2), path("pass.pdf")),
              QStringLiteral("NOAA 19 (33591): The recording has no ticks. It ended before the mount was measured."));
    EXPECT_FALSE(QFile::exists(path("pass.pdf")));
    EXPECT_TRUE(errorOf(passes, path("pass.pdf")).contains(QStringLiteral("one recording or of two")));
    EXPECT_TRUE(errorOf(std::span(passes).first(1), path("pass.txt")).contains(QStringLiteral(".pdf or .png")));
    const QString nowhere = path("no/folder/pass.png");
    EXPECT_TRUE(errorOf(std::span(passes).first(1), nowhere).startsWith(nowhere));
}

// The line of half of the beam is in the chart, unless it would leave no height for the error.
TEST(ReportPageTest, TheChartOfTheErrorFitsThePeak)
{
    Recording recording = recordedFor(100);
    for (recording::Tick& tick : recording.ticks) {
        tick.error = Angle::fromDegrees(0.5);
    }
    EXPECT_NEAR(errorChartTop(pageFor({&recording, 1})), 1.15 * 1.25, 1e-6);
    EXPECT_EQ(halfBeamText(pageFor({&recording, 1})), QStringLiteral("Half of the beam: 1.25°"));
    for (recording::Tick& tick : recording.ticks) {
        tick.error = Angle::fromDegrees(0.1);
    }
    EXPECT_NEAR(errorChartTop(pageFor({&recording, 1})), 1.15 * 0.1, 1e-6);
    recording.header.beamWidth = Angle();
    EXPECT_EQ(halfBeamText(pageFor({&recording, 1})), QString());
}

TEST(ReportChartTest, MarksAreRound)
{
    EXPECT_NEAR(markStep(10.0, 5), 2.0, 1e-12);
    EXPECT_NEAR(markStep(0.23, 5), 0.05, 1e-12);
    EXPECT_NEAR(markStep(7.0, 5), 2.0, 1e-12);
    EXPECT_NEAR(markStep(40.0, 5), 10.0, 1e-12);
    EXPECT_EQ(timeStep(Seconds(720.0), 7), Seconds(120.0));
    EXPECT_EQ(timeStep(Seconds(30.0), 7), Seconds(5.0));
    EXPECT_EQ(timeStep(Seconds(86'400.0), 7), Seconds(18'000.0));
}

// REQ-REPORT-22: A value without data and a pass of one tick leave their chart empty, and the page whole.
TEST(ReportPageTest, APageWithoutValuesIsWhole)
{
    Recording bare{.header = {}, .ticks = {recording::Tick{.utc = recording::kRecordedFrom}}};
    const ReportPage page = pageFor({&bare, 1});
    EXPECT_FALSE(QImage::fromData(pngOf(page)).isNull());
    EXPECT_TRUE(pdfOf(page).startsWith("%PDF-"));
}

}  // namespace
}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/report_file.h"

#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

schedule::PassRecord aPass(int number)
{
    return {.number = number,
            .name = QStringLiteral("SAT \"%1\"").arg(number),
            .aos = UtcTime(std::chrono::milliseconds(1'795'000'000'250)),
            .los = UtcTime(std::chrono::milliseconds(1'795'000'600'000)),
            .tracked = Seconds(599.5),
            .within1dB = Seconds(590.0),
            .within3dB = Seconds(598.5),
            .rmsError = 0.125_deg,
            .peakError = 1.5_deg,
            .end = schedule::PassEnd::Manual,
            .why = QStringLiteral("STOP of operator")};
}

class ReportFileTest : public testing::Test
{
protected:
    [[nodiscard]] QString path() const { return reportPath(m_folder.path(), QStringLiteral("mast"), false); }
    [[nodiscard]] std::size_t passes() const { return ReportFile(path()).report().passes.size(); }

    QTemporaryDir m_folder;
};

// REQ-SCHEDULE-906 (ReportFileTest.*): The night report is in a file and survives a restart with all its values. It is
// written by a worker, never in a tick, and is on the disk before the program ends. What cannot be read is not written
// over. What cannot be written is reported until it can.
TEST_F(ReportFileTest, TheReportIsThereAgain)
{
    const schedule::NightReport report{.passes = {aPass(25'544), aPass(7)}, .interventions = 2, .faults = 1};
    {
        ReportFile file(path());
        EXPECT_EQ(file.report(), schedule::NightReport{});
        file.keep({.passes = {aPass(25'544)}});
        file.keep(report);
    }
    ReportFile again(path());
    EXPECT_TRUE(again.problem().isEmpty()) << again.problem().toStdString();
    EXPECT_THAT(again.report().passes, testing::SizeIs(2));
    EXPECT_EQ(again.report().passes[0].aos, report.passes[0].aos);
    EXPECT_NEAR(again.report().passes[0].rmsError.degrees(), 0.125, 1e-9);
    EXPECT_EQ(again.report().passes[0].why, report.passes[0].why);
    EXPECT_EQ(again.report().passes[1].name, report.passes[1].name);
    EXPECT_EQ(again.report().passes[1].end, schedule::PassEnd::Manual);
    EXPECT_EQ(again.report().interventions, 2);
    EXPECT_EQ(again.report().faults, 1);
}

TEST_F(ReportFileTest, WhatCannotBeReadIsNotWrittenOver)
{
    const QByteArray text("version = 1\ninterventions = \"many\"\n");
    QFile broken(path());
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write(text);
    broken.close();
    {
        ReportFile file(path());
        EXPECT_THAT(file.problem().toStdString(), testing::HasSubstr(":2: interventions"));
        file.keep({.passes = {aPass(1)}});
        EXPECT_EQ(file.report().passes.size(), 1U) << "kept in memory";
    }
    ASSERT_TRUE(broken.open(QIODevice::ReadOnly));
    EXPECT_EQ(broken.readAll(), text);
}

TEST_F(ReportFileTest, WhatCannotBeWrittenIsReportedUntilItCan)
{
    ReportFile file(path());
    ASSERT_TRUE(QDir().mkpath(path()));  // nobody can write over it, not even root
    file.keep({.passes = {aPass(1)}});
    ASSERT_TRUE(fakes::waitUntil([&] { return !file.problem().isEmpty(); }));
    ASSERT_TRUE(QDir().rmdir(path()));
    file.keep({.passes = {aPass(1), aPass(2)}});
    ASSERT_TRUE(fakes::waitUntil([&] { return file.problem().isEmpty(); }));
    EXPECT_EQ(passes(), 2U);
}

TEST_F(ReportFileTest, ASimulatedMountHasItsOwn)
{
    EXPECT_NE(path(), reportPath(m_folder.path(), QStringLiteral("mast"), true));
}

}  // namespace
}  // namespace boresight

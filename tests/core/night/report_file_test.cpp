// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/report_file.h"

#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QThread>

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

// REQ-SCHEDULE-906 (ReportFileTest.*): The night report is in a file and survives a restart with all its values. A
// worker writes it, never a tick, and it is on the disk before the program ends. A file that cannot be read is not
// overwritten. A file that cannot be written is reported until it can. A pass that was running when the program was
// killed is shown as interrupted, with what was tracked of it. Each pass is in the report once.
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
    EXPECT_NEAR(again.report().passes[0].rmsError.value().degrees(), 0.125, 1e-9);
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
    ASSERT_TRUE(QDir().mkpath(path()));  // a folder: nobody can overwrite it, not even root
    file.keep({.passes = {aPass(1)}});
    ASSERT_TRUE(fakes::waitUntil([&] { return !file.problem().isEmpty(); }));
    ASSERT_TRUE(QDir().rmdir(path()));
    file.keep({.passes = {aPass(1), aPass(2)}});
    ASSERT_TRUE(fakes::waitUntil([&] { return file.problem().isEmpty(); }));
    EXPECT_EQ(passes(), 2U);
}

schedule::PassRecord begunPass(int number, Seconds tracked)
{
    schedule::PassRecord pass = aPass(number);
    pass.tracked = tracked;
    pass.end = schedule::PassEnd::Running;
    pass.why.clear();
    return pass;
}

// The folder after kill -9: what the worker has written, and no end of the pass.
TEST_F(ReportFileTest, APassThatWasRunningIsInterrupted)
{
    ReportFile killed(path());
    EXPECT_FALSE(killed.lostPass());
    killed.keepPass(begunPass(7, Seconds(30.5)));
    ASSERT_TRUE(fakes::waitUntil([&] { return ReportFile(path()).lostPass().has_value(); }));
    const schedule::PassRecord lost = *ReportFile(path()).lostPass();
    EXPECT_EQ(lost.end, schedule::PassEnd::Interrupted);
    EXPECT_FALSE(lost.why.isEmpty());
    EXPECT_EQ(lost.number, 7);
    EXPECT_EQ(lost.name, aPass(7).name);
    EXPECT_EQ(lost.aos, aPass(7).aos);
    EXPECT_NEAR(lost.tracked.count(), 30.5, 1e-9);
    EXPECT_LT(QFile(path() + QStringLiteral(".pass")).size(), 600) << "it is written often";
}

// The two files reach the disk in any order.
TEST_F(ReportFileTest, APassWithAnEndIsThereOnce)
{
    {
        ReportFile file(path());
        file.keepPass(aPass(7));
    }
    EXPECT_EQ(ReportFile(path()).lostPass()->end, schedule::PassEnd::Manual) << "killed before it was in the report";
    {
        ReportFile file(path());
        file.keepPass(aPass(7));
        file.keep({.passes = {aPass(7)}});
    }
    EXPECT_FALSE(ReportFile(path()).lostPass());
    {
        ReportFile file(path());
        file.keepPass(begunPass(7, Seconds(2.0)));
    }
    EXPECT_TRUE(ReportFile(path()).lostPass()) << "the same pass once more, after a manual act";
}

TEST_F(ReportFileTest, ATornPassCostsNothingElse)
{
    {
        ReportFile file(path());
        file.keep({.passes = {aPass(1)}});
        file.keepPass(begunPass(7, Seconds(30.0)));
    }
    QFile torn(path() + QStringLiteral(".pass"));
    ASSERT_TRUE(torn.resize(torn.size() / 2));
    ReportFile file(path());
    EXPECT_THAT(file.problem().toStdString(), testing::HasSubstr(".pass"));
    EXPECT_FALSE(file.lostPass());
    EXPECT_EQ(file.report().passes.size(), 1U);
    file.keepPass(begunPass(8, Seconds(1.0)));
    ASSERT_TRUE(fakes::waitUntil([&] { return file.problem().isEmpty(); }));
    EXPECT_EQ(ReportFile(path()).lostPass()->number, 8);
}

// Story: a station is made on the main thread and moved to its own thread. The writer of the pass stayed on the main
// thread, and two threads worked on it.
TEST_F(ReportFileTest, BothWritersGoToTheThreadOfTheFile)
{
    QThread other;
    auto* const file = new ReportFile(path());
    file->moveToThread(&other);
    const auto writers = file->findChildren<NewestWriter*>();
    EXPECT_EQ(writers.size(), 2);
    for (const NewestWriter* const writer : writers) {
        EXPECT_EQ(writer->thread(), &other);
    }
    QObject::connect(&other, &QThread::started, file, [file, &other] {
        delete file;
        other.quit();
    });
    other.start();
    EXPECT_TRUE(other.wait());
}

TEST_F(ReportFileTest, ASimulatedMountHasItsOwn)
{
    EXPECT_NE(path(), reportPath(m_folder.path(), QStringLiteral("mast"), true));
}

}  // namespace
}  // namespace boresight

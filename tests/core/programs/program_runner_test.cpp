// SPDX-License-Identifier: GPL-3.0-or-later
// Real programs are started.
#include "core/programs/program_runner.h"

#include "core/programs/program_worker.h"
#include "tests/fakes/wait_until.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight::programs {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;
using namespace std::chrono_literals;

const QString kShell = QStringLiteral("/bin/sh");

class ProgramRunnerTest : public ::testing::Test
{
protected:
    void begin(const Limits& limits = {})
    {
        runner = std::make_unique<ProgramRunner>(limits);
        QObject::connect(runner.get(), &ProgramRunner::ended, [this](const Ending& ending) {
            good = ending.good;
            endings.push_back(ending.text.toStdString());
        });
    }
    // The text that was reported at the end of the program.
    std::string run(const Job& job)
    {
        if (!runner) {
            begin();
        }
        const std::size_t before = endings.size();
        runner->run(job);
        EXPECT_TRUE(fakes::waitUntil([&] { return endings.size() > before; }));
        return endings.empty() ? std::string() : endings.back();
    }
    std::string shell(const QString& script)
    {
        return run({.path = kShell, .arguments = {QStringLiteral("-c"), script}});
    }
    [[nodiscard]] QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QByteArray written(const char* name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }

    QTemporaryDir folder;
    std::unique_ptr<ProgramRunner> runner;
    std::vector<std::string> endings;
    bool good = false;
};

// REQ-HOOKS-01: A program receives its facts in its environment, and its arguments unchanged: no shell reads them.
TEST_F(ProgramRunnerTest, FactsAreInTheEnvironmentAndNoShellReadsTheArguments)
{
    EXPECT_THAT(run({.path = kShell,
                     .arguments = {QStringLiteral("-c"), QStringLiteral("echo \"$BORESIGHT_EVENT\" \"$1\" >\"$2\""),
                                   QStringLiteral("hook"), QStringLiteral("$(id) `id`; * | >"), path("out")},
                     .environment = {{QStringLiteral("BORESIGHT_EVENT"), QStringLiteral("aos $(id)")}}}),
                StartsWith("/bin/sh ended after 0."));
    EXPECT_TRUE(good);
    EXPECT_EQ(written("out"), "aos $(id) $(id) `id`; * | >\n");
    run({.path = QStringLiteral("/bin/touch"), .arguments = {path("a b;c $HOME *")}});
    EXPECT_TRUE(QFile::exists(path("a b;c $HOME *")));
}

// REQ-HOOKS-02: The end of a program is reported with the first line of its standard error. A program that cannot be
// started is reported with the reason. All other output is discarded, whatever its size.
TEST_F(ProgramRunnerTest, ItsEndIsToldWithTheFirstLineOfItsErrors)
{
    EXPECT_THAT(shell(QStringLiteral("printf 'no \\033 device\\nmore\\n' >&2; exit 3")),
                AllOf(StartsWith("/bin/sh ended with status 3 after "), EndsWith(" s: no ? device")));
    EXPECT_FALSE(good);
    EXPECT_THAT(shell(QStringLiteral("kill -9 $$")), StartsWith("/bin/sh crashed after "));
    EXPECT_FALSE(good);
    const std::string flood =
        shell(QStringLiteral("head -c 3000000 /dev/zero | tr '\\0' e >&2; head -c 3000000 /dev/zero"));
    EXPECT_TRUE(good);
    EXPECT_THAT(flood, EndsWith("eee"));
    EXPECT_LT(flood.size(), 300U);
    EXPECT_EQ(run({.path = QStringLiteral("/no/such/program")}),
              "/no/such/program could not be started: No such file or directory");
    EXPECT_FALSE(good);
    EXPECT_EQ(run({.path = QStringLiteral("/etc/passwd")}), "/etc/passwd could not be started: Permission denied");
    EXPECT_EQ(run({.path = QStringLiteral("/etc")}), "/etc could not be started: Permission denied");
    EXPECT_THAT(shell(QStringLiteral("exit 0")), StartsWith("/bin/sh ended after "));
}

// REQ-HOOKS-03: A program that runs too long is asked to end, with all programs that it has started. If they do not end
// they are killed.
TEST_F(ProgramRunnerTest, WhatRunsForTooLongIsEnded)
{
    begin({.longest = 100ms, .patience = 20ms});
    const QString file = path("pid");
    EXPECT_EQ(shell(QStringLiteral("exec sleep 1000")),
              "/bin/sh was ended after 0.1 s, the longest time for a program");
    EXPECT_FALSE(good);
    begin({.longest = 2s, .patience = 30s});  // a busy computer starts the shell late
    shell(QStringLiteral("trap 'echo told >%1; exit 0' TERM; while :; do sleep 0.01; done").arg(file));
    EXPECT_EQ(written("pid"), "told\n");
    EXPECT_FALSE(good);
    begin({.longest = 2s, .patience = 20ms});
    shell(QStringLiteral("trap '' TERM; sleep 1000 & echo $! >%1; while :; do sleep 1000; done").arg(file));
    const QByteArray child = written("pid").trimmed();
    EXPECT_TRUE(fakes::waitUntil([&] {
        return !QFile::exists(QStringLiteral("/proc/%1").arg(QString::fromLatin1(child)));
    })) << child.toStdString();
}

// REQ-HOOKS-04: Programs run in parallel, up to a maximum number. One more is refused with the reason.
TEST_F(ProgramRunnerTest, NoMoreThanSoManyRunAtOnce)
{
    begin({.longest = 1min, .patience = 10ms, .most = 2});
    const Job waits{.path = QStringLiteral("/bin/sleep"), .arguments = {QStringLiteral("1000")}};
    runner->run(waits);
    runner->run(waits);
    EXPECT_EQ(run(waits), "/bin/sleep was not started: 2 programs run already");
    EXPECT_THAT(endings, SizeIs(1));
}

// A program that has ended does not count, also while its end is being reported.
// REQ-HOOKS-04
TEST(ProgramWorkerTest, TheNextOneStartsAtTheEndOfTheOneBefore)
{
    ProgramWorker worker({.longest = 1min, .patience = 10ms, .most = 1});
    const Job job{.path = QStringLiteral("/bin/true")};
    int ended = 0;
    QObject::connect(&worker, &ProgramWorker::ended, &worker, [&](const Ending& ending) {
        EXPECT_TRUE(ending.good) << ending.text.toStdString();
        if (++ended < 3) {
            worker.start(job);
        }
    });
    worker.start(job);
    EXPECT_TRUE(fakes::waitUntil([&] { return ended == 3; }));
}

// REQ-HOOKS-05: When Boresight ends, the running programs have a short time in common to end. Then they are killed.
TEST_F(ProgramRunnerTest, ItsOwnEndEndsTheProgramsToo)
{
    begin({.longest = 1min, .patience = 300ms});
    const QString stubborn = QStringLiteral("trap '' TERM; echo >%1; sleep 1000");
    runner->run({.path = kShell, .arguments = {QStringLiteral("-c"), stubborn.arg(path("one"))}});
    runner->run({.path = kShell, .arguments = {QStringLiteral("-c"), stubborn.arg(path("two"))}});
    ASSERT_TRUE(fakes::waitUntil([&] { return QFile::exists(path("one")) && QFile::exists(path("two")); }));
    runner->run({.path = QStringLiteral("/bin/touch"), .arguments = {path("last")}});
    QElapsedTimer time;
    time.start();
    runner.reset();
    EXPECT_LT(time.elapsed(), 30'000);
    EXPECT_TRUE(QFile::exists(path("last")));
}

}  // namespace
}  // namespace boresight::programs

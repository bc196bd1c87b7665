// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/journal_file.h"

#include "core/journal/journal_text.h"
#include "tests/core/journal/example_journal.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <memory>
#include <utility>

namespace {

std::atomic<int> foldersSynced = 0;  // by any thread of this program

}  // namespace

// Replaces the fsync() of the C library, and counts the calls.
extern "C" int fsync(int descriptor)
{
    struct stat info = {};
    foldersSynced += fstat(descriptor, &info) == 0 && S_ISDIR(info.st_mode) ? 1 : 0;
    return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace boresight::journal {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class JournalFileTest : public testing::Test
{
protected:
    [[nodiscard]] QString path() const { return m_dir.filePath(QStringLiteral("mast.memory.json")); }
    [[nodiscard]] QString previous() const { return path() + QStringLiteral(".previous"); }

    static void put(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        ASSERT_EQ(file.write(bytes), bytes.size());
    }

    static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    static MountJournal at(double degrees)
    {
        MountJournal journal = exampleJournal();
        journal.turns[0]->angle = Angle::fromDegrees(degrees);
        journal.turns[0]->moving = false;
        return journal;
    }

    [[nodiscard]] LoadedJournal load() const { return JournalFile(m_dir.path(), QStringLiteral("mast")).load(); }

    [[nodiscard]] QStringList corruptFiles() const
    {
        return QDir(m_dir.path()).entryList({QStringLiteral("*.corrupt-*")}, QDir::Files);
    }

    QTemporaryDir m_dir;
};

// REQ-MEMORY-04
TEST_F(JournalFileTest, AMissingFileIsAnEmptyMemoryAndSaid)
{
    const LoadedJournal loaded = load();
    EXPECT_EQ(loaded.journal, MountJournal());
    EXPECT_EQ(loaded.problem, QStringLiteral("The journal file %1 is missing").arg(path()));
}

// If the folder was not written before a power cut, a file in it has its old name, or none.
// REQ-MEMORY-04a: Saving also writes the folder to the disk, so that the new names survive a power cut.
TEST_F(JournalFileTest, TheFolderIsOnTheDiskAfterTheRenamings)
{
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    foldersSynced = 0;
    file.save(at(10.0));
    ASSERT_TRUE(file.flush());
    EXPECT_EQ(foldersSynced, 1);
    file.save(at(20.0));
    ASSERT_TRUE(file.flush());
    EXPECT_EQ(foldersSynced, 2);
}

// Story: with a pipe or /dev/zero in place of the journal the program never started, or filled its memory. Two files
// that were kept aside within a millisecond had the same name.
// REQ-MEMORY-04b: A pipe, a device or an endless file in place of the journal is refused at once, and kept aside.
TEST_F(JournalFileTest, WhatIsNoRegularFileIsRefusedAtOnceAndKeptAside)
{
    ASSERT_EQ(mkfifo(path().toLocal8Bit().constData(), 0600), 0);
    EXPECT_THAT(load().problem.toStdString(),
                HasSubstr("cannot be used: it is not a regular file. Boresight keeps it as"));
    EXPECT_FALSE(QFileInfo::exists(path()));
    for (const char* const endless : {"/dev/zero", "/dev/null"}) {
        ASSERT_TRUE(QFile::link(QString::fromLatin1(endless), path()));
        ASSERT_EQ(mkfifo(previous().toLocal8Bit().constData(), 0600), 0);
        const LoadedJournal loaded = load();
        EXPECT_EQ(loaded.journal, MountJournal());
        EXPECT_THAT(loaded.problem.toStdString(), HasSubstr("cannot be used")) << endless;
        EXPECT_FALSE(QFileInfo(path()).isSymLink());
    }
    EXPECT_EQ(QDir(m_dir.path()).entryList({QStringLiteral("*.corrupt-*")}, QDir::AllEntries | QDir::System).size(), 5);
}

// Story: two programs with the same mount name and the same state folder overwrote each other's journal.
// REQ-MEMORY-04c: Only one program at a time uses the journal of a mount. A second program reports the name and the
// process of the first.
TEST_F(JournalFileTest, ASecondProgramIsKeptOutAndToldByWhom)
{
    JournalFile first(m_dir.path(), QStringLiteral("mast"));
    ASSERT_TRUE(first.claim());
    JournalFile second(m_dir.path(), QStringLiteral("mast"));
    const Result<> refused = second.claim();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Busy);
    EXPECT_THAT(textOf(refused.error()), StartsWith(program_invocation_short_name + std::string(" (process ") +
                                                    std::to_string(getpid()) + ") already controls this mount"));
    EXPECT_TRUE(JournalFile(m_dir.path(), QStringLiteral("other")).claim()) << "another mount";
}

// REQ-MEMORY-04c
TEST_F(JournalFileTest, AKilledProgramKeepsNobodyOut)
{
    const pid_t child = fork();
    if (child == 0) {
        JournalFile file(m_dir.path(), QStringLiteral("mast"));
        raise(file.claim() ? SIGKILL : SIGTERM);
    }
    int how = 0;
    ASSERT_EQ(waitpid(child, &how, 0), child);
    ASSERT_TRUE(WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    JournalFile next(m_dir.path(), QStringLiteral("mast"));
    EXPECT_TRUE(next.claim());
}

// Story: a program that could not open the lock of another user went on without a lock.
TEST_F(JournalFileTest, ALockOfAnotherUserKeepsOthersOut)
{
    ASSERT_EQ(chmod(m_dir.path().toLocal8Bit().constData(), 0777), 0);
    auto first = std::make_unique<JournalFile>(m_dir.path(), QStringLiteral("mast"));
    ASSERT_TRUE(first->claim());
    const auto claimOfNobody = [this](mode_t mode) {
        constexpr uid_t kNobody = 65534;
        const bool root = geteuid() == 0;  // root may open everything
        EXPECT_EQ(chmod((path() + QStringLiteral(".lock")).toLocal8Bit().constData(), mode), 0);
        EXPECT_TRUE(!root || seteuid(kNobody) == 0);
        const Result<> claimed = JournalFile(m_dir.path(), QStringLiteral("mast")).claim();
        EXPECT_TRUE(!root || seteuid(0) == 0);
        return claimed ? std::pair(ErrorCode::Io, std::string())
                       : std::pair(claimed.error().code, textOf(claimed.error()));
    };
    const auto [denied, why] = claimOfNobody(0);
    EXPECT_EQ(denied, ErrorCode::Denied);
    EXPECT_THAT(why, HasSubstr("(Permission denied)"));
    EXPECT_EQ(claimOfNobody(0444).first, ErrorCode::Busy) << "whose it is does not matter, who holds it does";
    first.reset();
    EXPECT_EQ(claimOfNobody(0444).second, "") << "nobody holds it any more";
}

// Without a folder for the journal no lock is needed. Saving reports the missing folder.
// REQ-MEMORY-04c
TEST_F(JournalFileTest, AFolderThatIsNotThereNeedsNoLock)
{
    EXPECT_TRUE(JournalFile(m_dir.filePath(QStringLiteral("none")), QStringLiteral("mast")).claim());
}

// Story: a file that could not be opened was reported as "left there", and the second save overwrote it.
TEST_F(JournalFileTest, WhatCannotBeOpenedIsKeptAsideToo)
{
    ASSERT_TRUE(QDir().mkdir(path()));  // a folder: nobody can read it as a file, not even root
    EXPECT_TRUE(load().problem.contains(QStringLiteral("Boresight keeps it as")));
    EXPECT_FALSE(QFileInfo::exists(path()));
    EXPECT_EQ(QDir(m_dir.path()).entryList({QStringLiteral("*.corrupt-*")}).size(), 1);
}

TEST_F(JournalFileTest, WhatWasSavedIsLoaded)
{
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    QSignalSpy saved(&file, &JournalFile::saved);
    file.save(at(10.0));
    ASSERT_TRUE(fakes::waitUntil([&] { return saved.count() == 1; }));
    const LoadedJournal loaded = load();
    EXPECT_EQ(loaded.journal, at(10.0));
    EXPECT_EQ(loaded.problem, QString());
}

// REQ-MEMORY-03: Saving never blocks. The newest value wins. A failure is reported. When the program ends the last
// value is on the disk.
TEST_F(JournalFileTest, TheNewestValueWinsAndNoQueueGrows)
{
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    QSignalSpy saved(&file, &JournalFile::saved);
    for (int i = 1; i <= 500; ++i) {
        file.save(at(i));
    }
    ASSERT_TRUE(fakes::waitUntil([&] { return saved.count() == 2; }));
    EXPECT_EQ(load().journal, at(500.0));
    EXPECT_EQ(parseJournal(bytesOf(previous())), at(1.0));
    EXPECT_TRUE(file.flush());
    EXPECT_EQ(saved.count(), 2);
}

// REQ-MEMORY-03
TEST_F(JournalFileTest, FlushWaitsForTheLastValueWithoutAnEventLoop)
{
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    file.save(at(1.0));
    file.save(at(2.0));
    file.save(at(3.0));
    EXPECT_TRUE(file.flush());
    EXPECT_EQ(load().journal, at(3.0));
    file.save(at(4.0));
    EXPECT_TRUE(file.flush());
    EXPECT_EQ(load().journal, at(4.0));
}

// REQ-MEMORY-03
TEST_F(JournalFileTest, TheDestructorFlushes)
{
    {
        JournalFile file(m_dir.path(), QStringLiteral("mast"));
        file.save(at(1.0));
        file.save(at(2.0));
    }
    EXPECT_EQ(load().journal, at(2.0));
}

// REQ-MEMORY-04: At every moment there is a complete file on the disk. A missing file, a corrupt file and the use of
// the previous file are reported. A corrupt file is kept.
TEST_F(JournalFileTest, ACorruptFileIsKeptAsideAndThePreviousOneTaken)
{
    put(path(), QByteArrayLiteral("{ \"boresight_mem"));
    put(previous(), *toText(at(20.0)));
    const LoadedJournal loaded = load();
    MountJournal expected = at(20.0);
    for (auto& turn : expected.turns) {
        turn->host = {};  // the lost file may have been written because of a doubt, so this is no proof
    }
    EXPECT_EQ(loaded.journal, expected);
    ASSERT_EQ(corruptFiles().size(), 1);
    EXPECT_EQ(bytesOf(m_dir.filePath(corruptFiles().front())), QByteArrayLiteral("{ \"boresight_mem"));
    const std::string problem = loaded.problem.toStdString();
    EXPECT_THAT(problem, HasSubstr("cannot be used: it is damaged at byte"));
    EXPECT_THAT(problem, HasSubstr("Boresight keeps it as " + m_dir.filePath(corruptFiles().front()).toStdString()));
    EXPECT_THAT(problem, HasSubstr("Boresight uses the previous version: " + previous().toStdString()));
}

// REQ-MEMORY-04
TEST_F(JournalFileTest, BothCorruptIsAnEmptyMemoryAndBothAreKept)
{
    put(path(), QByteArrayLiteral("{}"));
    put(previous(), QByteArray(100, '\0'));
    const LoadedJournal loaded = load();
    EXPECT_EQ(loaded.journal, MountJournal());
    EXPECT_EQ(corruptFiles().size(), 2);
    EXPECT_THAT(loaded.problem.toStdString(), HasSubstr("it is not a position journal"));
    EXPECT_THAT(loaded.problem.toStdString(), HasSubstr("it is empty"));
}

// Killed between the two renamings: there is only the previous generation, and beside it the unfinished new one.
// REQ-MEMORY-04
TEST_F(JournalFileTest, KilledBetweenTheRenamingsThePreviousOneIsTaken)
{
    put(previous(), *toText(at(30.0)));
    put(path() + QStringLiteral(".XyZabc"), toText(at(31.0))->left(200));
    const LoadedJournal loaded = load();
    EXPECT_EQ(loaded.journal.turns[0]->angle, Angle::fromDegrees(30.0));
    EXPECT_EQ(loaded.journal.turns[0]->host, HostTime());
    EXPECT_THAT(loaded.problem.toStdString(), HasSubstr("is missing. Boresight uses the previous version: "));
}

// The program is killed at any moment of its writing. There is always a complete file, at most one save behind.
// REQ-MEMORY-04
// REQ-MEMORY-04c
TEST_F(JournalFileTest, AKilledProgramLeavesAWholeFile)
{
    for (int round = 1; round <= 25; ++round) {
        std::array<int, 2> pipe{};
        ASSERT_EQ(::pipe(pipe.data()), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            JournalFile file(m_dir.path(), QStringLiteral("mast"));
            for (unsigned char i = 1;; ++i) {
                file.save(at(i));
                (void)file.flush();
                (void)!::write(pipe[1], &i, 1);
            }
        }
        ASSERT_GT(child, 0);
        ::close(pipe[1]);
        unsigned char last = 0;
        for (int i = 0; i < 2 + round % 5; ++i) {
            ASSERT_EQ(::read(pipe[0], &last, 1), 1);
        }
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        while (::read(pipe[0], &last, 1) == 1) {
        }
        ::close(pipe[0]);
        const LoadedJournal loaded = load();
        ASSERT_TRUE(loaded.journal.turns[0]) << loaded.problem.toStdString();
        const double found = std::round(loaded.journal.turns[0]->angle.degrees());
        EXPECT_GE(found, last);  // the last value reported as saved, or the one being written
        EXPECT_LE(found, last + 1);
        EXPECT_EQ(corruptFiles().size(), 0);
    }
}

TEST_F(JournalFileTest, AHugeFileDoesNotFillTheMemory)
{
    QFile file(path());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_TRUE(file.resize(qint64(4) << 30));  // sparse
    file.close();
    EXPECT_THAT(load().problem.toStdString(), HasSubstr("it is too large"));
    EXPECT_EQ(corruptFiles().size(), 1);
}

// REQ-MEMORY-03
TEST_F(JournalFileTest, AFailureIsTold)
{
    JournalFile file(m_dir.filePath(QStringLiteral("nowhere")), QStringLiteral("mast"));
    QSignalSpy failed(&file, &JournalFile::saveFailed);
    QSignalSpy saved(&file, &JournalFile::saved);
    file.save(at(1.0));
    ASSERT_TRUE(fakes::waitUntil([&] { return failed.count() == 1; }));
    EXPECT_EQ(saved.count(), 0);
    EXPECT_THAT(failed[0][0].toString().toStdString(), StartsWith(file.path().toStdString() + ": "));
    const auto flushed = file.flush();
    ASSERT_FALSE(flushed);
    EXPECT_THAT(textOf(flushed.error()), StartsWith(file.path().toStdString()));
}

TEST_F(JournalFileTest, WhatNoAxisCanBeLeavesTheGoodFileAlone)
{
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    file.save(at(1.0));
    ASSERT_TRUE(file.flush());
    file.save(at(std::nan("")));
    const auto flushed = file.flush();
    ASSERT_FALSE(flushed);
    EXPECT_EQ(textOf(flushed.error()), "azimuth.turn.angle_rad is not finite");
    EXPECT_EQ(load().journal, at(1.0));
}

TEST_F(JournalFileTest, LivesInAnotherThreadThanTheOneThatMadeIt)
{
    QThread station;
    JournalFile file(m_dir.path(), QStringLiteral("mast"));
    file.moveToThread(&station);
    // reported in the station's thread
    QObject::connect(&file, &JournalFile::saved, &file, [&station] { station.quit(); });
    station.start();
    QMetaObject::invokeMethod(&file, [&file] { file.save(at(7.0)); });
    ASSERT_TRUE(station.wait(60'000));
    EXPECT_EQ(load().journal, at(7.0));
}

}  // namespace
}  // namespace boresight::journal

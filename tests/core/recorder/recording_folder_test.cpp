// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/recording_folder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <chrono>

namespace boresight::recorder {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr UtcTime kFolderNow{1'795'000'000s};  // 2026-11-18T11:06:40Z

std::vector<StoredRecording> threeDays()
{
    return {{.name = QStringLiteral("a"), .began = kFolderNow - 72h, .bytes = 100},
            {.name = QStringLiteral("b"), .began = kFolderNow - 48h, .bytes = 200},
            {.name = QStringLiteral("c"), .began = kFolderNow - 24h, .bytes = 300}};
}

TEST(RecordingFolder, ANameHasTimeAndTarget)
{
    EXPECT_EQ(recordingName(kFolderNow, QStringLiteral("NOAA 19")),
              QStringLiteral("20261118T110640Z_NOAA_19.recording"));
    EXPECT_EQ(recordingName(kFolderNow, QStringLiteral("../é/x")), QStringLiteral("20261118T110640Z______x.recording"));
    EXPECT_EQ(recordingName(kFolderNow, {}), QStringLiteral("20261118T110640Z.recording"));
}

// REQ-RECORD-06: Recordings go when they are older than the profile permits, and the oldest ones go while all together
// are larger than permitted.
TEST(RecordingFolder, OldOnesGoByAgeAndBySize)
{
    EXPECT_THAT(expired(threeDays(), {.age = std::chrono::days(30), .bytes = 600}, kFolderNow), IsEmpty());
    EXPECT_THAT(expired(threeDays(), {.age = std::chrono::days(1), .bytes = 600}, kFolderNow),
                ElementsAre(QStringLiteral("a"), QStringLiteral("b")));
    EXPECT_THAT(expired(threeDays(), {.age = std::chrono::days(30), .bytes = 599}, kFolderNow),
                ElementsAre(QStringLiteral("a")));
    EXPECT_THAT(expired(threeDays(), {.age = std::chrono::days(30), .bytes = 299}, kFolderNow),
                ElementsAre(QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")));
}

// REQ-RECORD-15
TEST(RecordingFolder, TheFileInWritingCountsAndStays)
{
    EXPECT_THAT(expired(threeDays(), {.age = std::chrono::days(1), .bytes = 0}, kFolderNow, QStringLiteral("b")),
                ElementsAre(QStringLiteral("a"), QStringLiteral("c")));
}

// REQ-RECORD-17: While no time source sets the clock, no recording is deleted for its age. The size always counts.
TEST(RecordingFolder, WithoutAnAgeOnlyTheSizeCounts)
{
    EXPECT_THAT(expired(threeDays(), {.age = std::nullopt, .bytes = 600}, kFolderNow + 100'000h), IsEmpty());
    EXPECT_THAT(expired(threeDays(), {.age = std::nullopt, .bytes = 500}, kFolderNow),
                ElementsAre(QStringLiteral("a")));
}

// REQ-RECORD-06
TEST(RecordingFolder, OnlyRecordingsAreDeleted)
{
    const QTemporaryDir folder;
    const auto make = [&folder](const QString& name) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    };
    const QString old = recordingName(kFolderNow - 100h, QStringLiteral("OLD"));
    const QString young = recordingName(kFolderNow - 1h, QStringLiteral("YOUNG"));
    for (const QString& name :
         {old, young, QStringLiteral("notes.recording"), QStringLiteral("20200101T000000Z.txt")}) {
        make(name);
    }
    deleteExpired(folder.path(), {.age = std::chrono::days(1)}, kFolderNow);
    EXPECT_THAT(QDir(folder.path()).entryList(QDir::Files),
                testing::UnorderedElementsAre(young, QStringLiteral("notes.recording"),
                                              QStringLiteral("20200101T000000Z.txt")));
}

TEST(RecordingFolder, AFailedWriteLeavesNothing)
{
    const QTemporaryDir folder;
    EXPECT_TRUE(appendWhole(folder.filePath(QStringLiteral("a")), "one"));
    EXPECT_TRUE(appendWhole(folder.filePath(QStringLiteral("a")), "two"));
    QFile file(folder.filePath(QStringLiteral("a")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), "onetwo");
    const Result<> full = appendWhole(QStringLiteral("/dev/full"), "one");
    ASSERT_FALSE(full);
    EXPECT_THAT(full.error().text.toStdString(), testing::HasSubstr("/dev/full"));
}

}  // namespace
}  // namespace boresight::recorder

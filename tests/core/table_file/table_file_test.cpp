// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table_file/table_file.h"

#include "tests/fakes/text_of.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace boresight::tables {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class TableFileTest : public testing::Test
{
protected:
    QString write(const char* name, const QByteArray& bytes) const
    {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }
    static std::string refusal(const QString& path)
    {
        const auto table = readTableFile(path);
        return table ? "accepted" : textOf(table.error());
    }

    QTemporaryDir folder;
};

// REQ-TABLES-940: The table in a file is read. An error names the file and the line.
TEST_F(TableFileTest, ReadsTheTableOrNamesTheLine)
{
    const auto table = readTableFile(write("moon.csv", "2026-12-24T00:00:00Z,10,20\n2026-12-24T00:01:00Z,11,21\n"));
    ASSERT_TRUE(table);
    EXPECT_EQ((*table)->name, QStringLiteral("moon.csv"));
    const QString bad = write("bad.csv", "2026-12-24T00:00:00Z,10,20\n2026-12-24T00:01:00Z,11,nan\n");
    EXPECT_THAT(refusal(bad), StartsWith(bad.toStdString() + ":2: The elevation \"nan\""));
}

// REQ-TABLES-941: Anything but a regular file is refused without being opened, because a pipe would block the reader.
// Of a file above 100 MB nothing more is read.
TEST_F(TableFileTest, RefusesWhatIsNoFileOrTooLarge)
{
    EXPECT_THAT(refusal(folder.filePath(QStringLiteral("none"))), HasSubstr("none: There is no such file."));
    EXPECT_THAT(refusal(folder.path()), HasSubstr("This is not a file."));
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    ASSERT_EQ(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    EXPECT_THAT(refusal(pipe), HasSubstr("pipe: This is not a file."));
    QFile huge(folder.filePath(QStringLiteral("huge")));
    ASSERT_TRUE(huge.open(QIODevice::WriteOnly));
    ASSERT_TRUE(huge.resize((kMostTableMegabytes << 20) + 1));
    EXPECT_THAT(refusal(huge.fileName()), HasSubstr("huge: The file is larger than 100 MB. Split it."));
}

}  // namespace
}  // namespace boresight::tables

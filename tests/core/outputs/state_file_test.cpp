// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/state_file.h"

#include "core/base/text.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

namespace boresight::outputs {
namespace {

using testing::HasSubstr;

class StateFile : public testing::Test
{
protected:
    [[nodiscard]] QByteArray content() const
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }
    void put(const QByteArray& bytes) const
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("transmit"));
};

// REQ-TRANSMIT-10: The file contains the line "on" or "off". It is written in place: its permissions and links stay.
TEST_F(StateFile, HasOneLine)
{
    ASSERT_TRUE(writeState(path, false));
    EXPECT_EQ(content(), "off\n");
    ASSERT_TRUE(writeState(path, true));
    EXPECT_EQ(content(), "on\n");
    ASSERT_TRUE(writeState(path, true));
    EXPECT_EQ(content(), "on\n");
    ASSERT_TRUE(writeState(path, false));
    EXPECT_EQ(content(), "off\n");
    put("on\nand much more of another program\n");
    ASSERT_TRUE(writeState(path, false));
    EXPECT_EQ(content(), "off\n");
    put("on\nand much more of another program\n");
    ASSERT_TRUE(writeState(path, true));
    EXPECT_EQ(content(), "on\n");
}

// REQ-TRANSMIT-10
TEST_F(StateFile, StaysTheFileThatItIs)
{
    put("");
    ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
    const QString link = folder.filePath(QStringLiteral("link"));
    ASSERT_TRUE(QFile::link(path, link));
    ASSERT_TRUE(writeState(link, true));
    EXPECT_EQ(content(), "on\n");
    EXPECT_TRUE(QFileInfo(link).isSymbolicLink());
    EXPECT_FALSE(QFile::permissions(path).testFlag(QFile::ReadOther));
}

// REQ-TRANSMIT-11: The time of the file is renewed each second. From this time its reader sees whether Boresight has
// died.
TEST_F(StateFile, RenewsItsTime)
{
    ASSERT_TRUE(writeState(path, true));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const QDateTime old = QDateTime::fromSecsSinceEpoch(1000, Qt::UTC);
    ASSERT_TRUE(file.setFileTime(old, QFileDevice::FileModificationTime));
    file.close();
    ASSERT_TRUE(writeState(path, true));
    EXPECT_GT(QFileInfo(path).lastModified(), old.addYears(1));
    EXPECT_EQ(content(), "on\n");
}

// REQ-TRANSMIT-12: A file that cannot be written is an error with the path and the reason: no folder, no permission, a
// folder, a pipe without a reader, a full disk.
TEST_F(StateFile, SaysWhyItCannotBeWritten)
{
    const auto reason = [](const QString& where) {
        const Result<> done = writeState(where, true);
        return done ? std::string("written") : done.error().text.toStdString();
    };
    EXPECT_EQ(reason(QStringLiteral("/no/such/folder/transmit")),
              "/no/such/folder/transmit: No such file or directory");
    EXPECT_THAT(reason(folder.path()), HasSubstr("Is a directory"));
    ASSERT_EQ(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    EXPECT_THAT(reason(path), HasSubstr("No such device or address"));
    EXPECT_THAT(reason(QStringLiteral("/dev/full")), HasSubstr("is not a file"));
}

// As on a full disk, nothing more can be written.
// REQ-TRANSMIT-12
TEST_F(StateFile, IsEmptyWhereNothingCanBeWritten)
{
    ASSERT_TRUE(writeState(path, true));
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
    const Result<> off = writeState(path, false);
    const QByteArray left = content();
    const Result<> on = writeState(path, true);
    const QByteArray then = content();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(off);
    EXPECT_EQ(left, "") << "which is not on";
    ASSERT_FALSE(on);
    EXPECT_THAT(on.error().text.toStdString(), HasSubstr("File too large"));
    EXPECT_EQ(then, "");
}

}  // namespace
}  // namespace boresight::outputs

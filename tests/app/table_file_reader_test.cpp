// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/table_file_reader.h"

#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <semaphore>
#include <thread>
#include <vector>

namespace boresight::app {
namespace {

using testing::StartsWith;

const QByteArray kTwoRows = "1700000000 1 2\n1700000060 2 3\n";

class TableFileReaderTest : public testing::Test
{
protected:
    QString write(const char* name, const QByteArray& text) const
    {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    void listen(TableFileReader& reader)
    {
        QObject::connect(&reader, &TableFileReader::wasRead, &reader,
                         [this](const SharedTableContent& content) { answers.push_back(content); });
    }
    // The next answer. Null: none came.
    SharedTableContent next(TableFileReader& reader, const QString& path, const SharedTableContent& known = nullptr)
    {
        const std::size_t before = answers.size();
        reader.read(path, known);
        EXPECT_EQ(answers.size(), before) << "not at once";
        return fakes::waitUntil([&] { return answers.size() > before; }) ? answers.back() : nullptr;
    }

    QTemporaryDir folder;
    std::vector<SharedTableContent> answers;
};

// REQ-APP-60: The file of a table is read beside the window. The answer is the table, or the file, the line and the
// reason.
TEST_F(TableFileReaderTest, ReadsBesideTheWindow)
{
    TableFileReader reader;
    listen(reader);
    const SharedTableContent good = next(reader, write("way.csv", kTwoRows));
    ASSERT_TRUE(good && good->table);
    EXPECT_EQ(good->table->name, QStringLiteral("way.csv"));
    const QString path = write("bad.csv", "1700000000 1 2\n1700000060 1 200\n");
    const SharedTableContent bad = next(reader, path);
    ASSERT_TRUE(bad && !bad->table);
    EXPECT_THAT(textOf(bad->table.error()), StartsWith(path.toStdString() + ":2: The elevation is 200°."));
    const SharedTableContent none = next(reader, folder.filePath(QStringLiteral("none.csv")));
    ASSERT_TRUE(none && !none->table);
    EXPECT_THAT(textOf(none->table.error()), testing::HasSubstr("There is no such file."));
}

// REQ-APP-61: A file is not read again while it is unchanged. A changed, new or removed file is, and one that could not
// be read.
TEST_F(TableFileReaderTest, ReadsAgainOnlyWhatHasChanged)
{
    TableFileReader reader;
    listen(reader);
    const QString path = folder.filePath(QStringLiteral("way.csv"));
    const SharedTableContent none = next(reader, path);
    ASSERT_TRUE(none && !none->table);
    write("way.csv", kTwoRows);
    const SharedTableContent two = next(reader, path, none);
    ASSERT_TRUE(two && two->table);
    EXPECT_EQ(next(reader, path, two), two);
    write("way.csv", kTwoRows + "1700000120 3 4\n");
    const SharedTableContent three = next(reader, path, two);
    ASSERT_TRUE(three && three->table);
    EXPECT_EQ(std::get<tables::DirectionRows>(std::get<tables::SharedTable>(three->table->kind)->rows).size(), 3U);
    QFile::remove(path);
    const SharedTableContent gone = next(reader, path, three);
    EXPECT_TRUE(gone && !gone->table);
}

// Story: an error of the folder stayed until the file changed.
// REQ-APP-61
TEST_F(TableFileReaderTest, ReadsAgainWhatTheFolderRefused)
{
    ErrorCode code = ErrorCode::Io;
    TableFileReader reader([&code](const QString& path) -> Result<tables::SharedTable> { return failure(code, path); });
    listen(reader);
    const QString path = write("way.csv", kTwoRows);
    const SharedTableContent refused = next(reader, path);
    ASSERT_TRUE(refused && !refused->table);
    code = ErrorCode::InvalidInput;
    const SharedTableContent mistake = next(reader, path, refused);
    ASSERT_TRUE(mistake && !mistake->table);
    EXPECT_EQ(mistake->table.error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(next(reader, path, mistake), mistake);
}

// Like a folder of another computer that does not answer.
class BlockedFiles
{
public:
    [[nodiscard]] TableFileReader::Read reader()
    {
        return [this](const QString& path) -> Result<tables::SharedTable> {
            if (path.contains(QStringLiteral("blocked"))) {
                ++m_inside;
                m_gate.acquire();
                --m_inside;
                ++m_left;
            }
            return failure(ErrorCode::NoDevice, path);
        };
    }
    void release()
    {
        const int inside = m_inside;
        const int all = m_left + inside;
        m_gate.release(inside);
        EXPECT_TRUE(fakes::waitUntil([&] { return m_left == all; }));
    }
    [[nodiscard]] int inside() const { return m_inside; }

private:
    std::atomic<int> m_inside = 0;
    std::atomic<int> m_left = 0;
    std::counting_semaphore<> m_gate{0};
};

// Story: each file that was typed in a dead folder held another thread, until no file of any folder was read.
// REQ-APP-62: A folder that does not answer does not keep files of others from being read. It holds one reader. The
// newest question for it is answered as soon as it answers.
TEST_F(TableFileReaderTest, ABlockedFolderHoldsOneReader)
{
    BlockedFiles files;
    TableFileReader reader(files.reader());
    listen(reader);
    reader.read(QStringLiteral("/blocked/a"), nullptr);
    ASSERT_TRUE(fakes::waitUntil([&] { return files.inside() == 1; }));
    for (std::size_t i = 0; i < TableFileReader::kMostThreads; ++i) {
        reader.read(QStringLiteral("/blocked/ab"), nullptr);
    }
    EXPECT_TRUE(next(reader, QStringLiteral("/good/way.csv")));
    EXPECT_EQ(files.inside(), 1);
    reader.read(QStringLiteral("/blocked/older"), nullptr);
    reader.read(QStringLiteral("/blocked/newest"), nullptr);
    answers.clear();
    files.release();
    ASSERT_TRUE(fakes::waitUntil([&] { return files.inside() == 1; }));
    files.release();
    ASSERT_TRUE(fakes::waitUntil([&] { return answers.size() == 2; }));
    EXPECT_EQ(answers[0]->path, QStringLiteral("/blocked/a"));
    EXPECT_EQ(answers[1]->path, QStringLiteral("/blocked/newest"));
}

// REQ-APP-64: When too many folders do not answer, the newest question is answered as soon as one of them does.
TEST_F(TableFileReaderTest, TheNewestQuestionWaitsForAReader)
{
    BlockedFiles files;
    TableFileReader reader(files.reader());
    listen(reader);
    for (std::size_t i = 0; i < TableFileReader::kMostThreads; ++i) {
        reader.read(QStringLiteral("/blocked%1/a").arg(i), nullptr);
    }
    ASSERT_TRUE(fakes::waitUntil([&] { return files.inside() == int{TableFileReader::kMostThreads}; }));
    reader.read(QStringLiteral("/older"), nullptr);
    reader.read(QStringLiteral("/newest"), nullptr);
    files.release();
    ASSERT_TRUE(fakes::waitUntil([&] { return answers.size() == TableFileReader::kMostThreads + 1; }));
    const auto isAnswered = [this](const QString& path) {
        return std::ranges::any_of(answers, [&](const SharedTableContent& one) { return one->path == path; });
    };
    EXPECT_TRUE(isAnswered(QStringLiteral("/newest")));
    EXPECT_FALSE(isAnswered(QStringLiteral("/older")));
}

// REQ-APP-63: A file that does not answer does not keep the program from ending.
TEST_F(TableFileReaderTest, ABlockedFileDoesNotKeepTheProgram)
{
    BlockedFiles files;
    {
        TableFileReader reader(files.reader());
        reader.read(QStringLiteral("/blocked"), nullptr);
        ASSERT_TRUE(fakes::waitUntil([&] { return files.inside() == 1; }));
    }
    EXPECT_EQ(files.inside(), 1) << "it was not waited for";
    files.release();
}

}  // namespace
}  // namespace boresight::app

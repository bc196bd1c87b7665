// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/table_question.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include <vector>

namespace boresight::ui {
namespace {

const QString kWay = QStringLiteral("/tmp/way.csv");

// A question, and a reader that answers when the test says so.
class TableQuestionTest : public ::testing::Test
{
protected:
    TableQuestionTest() : question(host), answers(&question, &TableQuestion::answered)
    {
        QObject::connect(&host, &HostDesk::tableWanted, &host,
                         [this](const QString& path, const SharedTableContent& known) {
                             paths.push_back(path);
                             knownLast = known;
                         });
        question.showStatus(status);
    }

    void showLater(std::chrono::milliseconds later)
    {
        status.utc += later;
        question.showStatus(status);
    }
    SharedTableContent answer(const QString& path, const Result<targets::Target>& outcome)
    {
        const auto content =
            std::make_shared<const TableContent>(TableContent{.path = path, .state = {}, .table = outcome});
        Q_EMIT host.tableRead(content);
        return content;
    }

    const targets::Target table{.name = QStringLiteral("way.csv"), .kind = tables::SharedTable()};
    const Result<targets::Target> missing = failure(ErrorCode::NoDevice, QStringLiteral("There is no such file."));
    HostDesk host{{}};
    TableQuestion question;
    QSignalSpy answers;
    StationStatus status;
    std::vector<QString> paths;  // asked
    SharedTableContent knownLast;
};

// REQ-TARGETS-965: While a path is typed, no file is read. It is read after a pause of half a second.
TEST_F(TableQuestionTest, AsksAfterAPauseOfTyping)
{
    question.ask(QStringLiteral("/tmp/w"));
    EXPECT_TRUE(question.isReading());
    showLater(std::chrono::milliseconds(400));
    question.ask(kWay);
    showLater(std::chrono::milliseconds(400));
    EXPECT_TRUE(paths.empty());
    showLater(std::chrono::milliseconds(100));
    EXPECT_EQ(paths, std::vector<QString>{kWay});
    EXPECT_EQ(question.whyNot(), QStringLiteral("Boresight is reading the file. Wait a moment."));
    answer(kWay, table);
    EXPECT_EQ(answers.count(), 1);
    EXPECT_EQ(question.whyNot(), QString());
    EXPECT_EQ(question.table(), table);
}

// REQ-TARGETS-966: While the path of a file stands in the field, the file is looked at again every 2 s, because it may
// change or disappear. The last answer counts until the next one.
TEST_F(TableQuestionTest, AsksAgainBecauseAFileMayChange)
{
    question.ask(kWay);
    showLater(std::chrono::seconds(1));
    const SharedTableContent first = answer(kWay, table);
    showLater(std::chrono::milliseconds(1900));
    EXPECT_EQ(paths.size(), 1U);
    showLater(std::chrono::milliseconds(100));
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(knownLast, first);
    EXPECT_EQ(question.whyNot(), QString());
    showLater(std::chrono::seconds(5));
    EXPECT_EQ(paths.size(), 2U) << "the reader has not answered yet";
    Q_EMIT host.tableRead(first);
    EXPECT_EQ(answers.count(), 1) << "nothing is new";
    showLater(std::chrono::seconds(2));
    answer(kWay, missing);
    EXPECT_EQ(answers.count(), 2);
    EXPECT_EQ(question.whyNot(), QStringLiteral("There is no such file."));
    EXPECT_FALSE(question.table());
}

// REQ-TARGETS-965
TEST_F(TableQuestionTest, AnAnswerAboutAnotherFileDoesNotCount)
{
    question.ask(QStringLiteral("/tmp/old.csv"));
    showLater(std::chrono::seconds(1));
    question.ask(kWay);
    answer(QStringLiteral("/tmp/old.csv"), table);
    EXPECT_FALSE(question.table());
    showLater(std::chrono::seconds(1));
    EXPECT_EQ(paths.back(), kWay);
    question.drop();
    answer(kWay, missing);
    EXPECT_EQ(question.whyNot(), QString());
    EXPECT_EQ(answers.count(), 0);
}

// The folder of another computer may not answer.
// REQ-TARGETS-967: After 30 s without an answer the window shows that the file was not read, also if it was read
// before. Track is offered: the station decides. An answer that comes later counts.
TEST_F(TableQuestionTest, AFolderThatDoesNotAnswerIsTold)
{
    question.ask(kWay);
    showLater(std::chrono::seconds(1));
    answer(kWay, table);
    showLater(std::chrono::seconds(2));
    showLater(std::chrono::milliseconds(29'900));
    EXPECT_EQ(question.doubt(), QString());
    showLater(std::chrono::milliseconds(100));
    EXPECT_EQ(question.doubt(),
              QStringLiteral("/tmp/way.csv was not read within 30 s. Its folder or that of an earlier file may not "
                             "answer. Track tries to read the file all the same."));
    EXPECT_EQ(question.whyNot(), QString());
    EXPECT_FALSE(question.isReading());
    answer(kWay, missing);
    EXPECT_EQ(question.doubt(), QString());
    EXPECT_EQ(question.whyNot(), QStringLiteral("There is no such file."));
}

}  // namespace
}  // namespace boresight::ui

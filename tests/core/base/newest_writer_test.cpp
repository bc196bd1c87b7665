// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/newest_writer.h"

#include "tests/fakes/wait_until.h"

#include <QThread>

#include <gmock/gmock.h>

#include <future>
#include <vector>

namespace boresight {
namespace {

TEST(NewestWriter, OfTheJobsThatComeInMeanwhileTheNewestWins)
{
    std::promise<void> disk;
    const std::shared_future<void> ready = disk.get_future();
    std::vector<int> written;
    NewestWriter writer;
    for (int i = 1; i <= 5; ++i) {
        writer.write([&written, ready, i]() -> Result<> {
            ready.wait();
            written.push_back(i);
            return {};
        });
    }
    disk.set_value();
    EXPECT_TRUE(writer.flush());
    EXPECT_THAT(written, testing::ElementsAre(1, 5));
}

TEST(NewestWriter, WritesOnItsWorkerAndReportsHowEachJobEnded)
{
    std::vector<bool> ended;
    const QThread* by = nullptr;
    NewestWriter writer;
    const QObject here;
    QObject::connect(&writer, &NewestWriter::written, &here, [&] { ended.push_back(true); });
    QObject::connect(&writer, &NewestWriter::failed, &here, [&](const QString& reason) {
        EXPECT_EQ(reason.toStdString(), "the disk is full");
        ended.push_back(false);
    });
    writer.write([&]() -> Result<> {
        by = QThread::currentThread();
        return failure(ErrorCode::Io, QStringLiteral("the disk is full"));
    });
    ASSERT_TRUE(fakes::waitUntil([&] { return ended.size() == 1U; }));
    EXPECT_FALSE(ended.back());
    EXPECT_NE(by, QThread::currentThread());
    writer.write([]() -> Result<> { return {}; });
    ASSERT_TRUE(fakes::waitUntil([&] { return ended.size() == 2U; }));
    EXPECT_TRUE(ended.back());
}

TEST(NewestWriter, TheNewestIsWrittenBeforeItsEnd)
{
    int written = 0;
    {
        NewestWriter writer;
        for (int i = 1; i <= 3; ++i) {
            writer.write([&written, i]() -> Result<> {
                written = i;
                return {};
            });
        }
    }
    EXPECT_EQ(written, 3);
}

}  // namespace
}  // namespace boresight

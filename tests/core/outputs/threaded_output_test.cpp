// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/threaded_output.h"

#include "core/base/text.h"
#include "tests/fakes/wait_until.h"

#include <QSemaphore>
#include <QThread>

#include <gmock/gmock.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace boresight::outputs {
namespace {

using testing::ElementsAre;

// A slow disk: each call waits until the test lets it go.
struct SlowDisk
{
    Result<> write(bool on)
    {
        asked.release();
        gate.acquire();
        written.push_back(on);
        thread = QThread::currentThread();
        return fails ? failure(ErrorCode::Io, QStringLiteral("disk full")) : Result<>{};
    }

    QSemaphore asked;
    QSemaphore gate;
    std::vector<bool> written;  // read while no call runs
    std::atomic<QThread*> thread = nullptr;
    std::atomic<bool> fails = false;
};

class ThreadedOutputTest : public testing::Test
{
protected:
    ThreadedOutputTest()
    {
        QObject::connect(output.get(), &Output::reached, output.get(),
                         [this](bool on) { told.emplace_back(on ? "on" : "off"); });
        QObject::connect(output.get(), &Output::failed, output.get(),
                         [this](const QString& reason) { told.push_back(reason.toStdString()); });
    }
    [[nodiscard]] bool tells(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return told.size() >= count; });
    }

    SlowDisk disk;
    std::unique_ptr<ThreadedOutput> output =
        std::make_unique<ThreadedOutput>([this](bool on) { return disk.write(on); });
    std::vector<std::string> told;
};

// REQ-TRANSMIT-13: A disk or an adapter that hangs delays nothing else. Of the waiting states only the newest is set.
TEST_F(ThreadedOutputTest, TheNewestOfThoseThatWaitCounts)
{
    output->set(false);
    disk.asked.acquire();
    output->set(true);
    output->set(false);
    output->set(true);
    EXPECT_TRUE(told.empty());
    EXPECT_FALSE(output->isIdle());
    disk.gate.release();
    ASSERT_TRUE(tells(1));
    EXPECT_FALSE(output->isIdle()) << "the next one is under way";
    disk.gate.release();
    ASSERT_TRUE(tells(2));
    EXPECT_TRUE(output->isIdle());
    EXPECT_THAT(told, ElementsAre("off", "on"));
    EXPECT_THAT(disk.written, ElementsAre(false, true));
    EXPECT_NE(disk.thread, QThread::currentThread());
}

// REQ-TRANSMIT-13
TEST_F(ThreadedOutputTest, EachTroubleIsTold)
{
    disk.fails = true;
    disk.gate.release(2);
    output->set(true);
    ASSERT_TRUE(tells(1));
    disk.fails = false;
    output->set(true);
    ASSERT_TRUE(tells(2));
    EXPECT_THAT(told, ElementsAre("disk full", "on"));
}

// The last requested state is set, also at the end.
// REQ-TRANSMIT-13
TEST_F(ThreadedOutputTest, ItsEndSetsWhatWasAskedLast)
{
    output->set(true);
    disk.asked.acquire();
    output->set(false);
    disk.gate.release(2);
    output.reset();
    EXPECT_THAT(disk.written, ElementsAre(true, false));
}

}  // namespace
}  // namespace boresight::outputs

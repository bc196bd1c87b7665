// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/edge_thread.h"

#include <gmock/gmock.h>

#include <semaphore>
#include <vector>

namespace boresight {
namespace {

using testing::ElementsAre;

// Records the thread on which it was destroyed.
struct Inside : QObject
{
    explicit Inside(QThread*& destroyedOn_) : destroyedOn(destroyedOn_) {}
    ~Inside() override { destroyedOn = QThread::currentThread(); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

    QThread*& destroyedOn;
};

// REQ-MQTT-09d (EdgeThread.*)
// REQ-BASE-04 (EdgeThread.*): A connection that others can keep busy has its own thread. Other threads wait for it only
// at its end, when all posted jobs are done.
TEST(EdgeThread, JobsRunInOrderOnTheThreadAndNobodyWaits)
{
    QThread* destroyedOn = nullptr;
    QThread* ranOn = nullptr;
    std::vector<int> jobs;
    std::binary_semaphore go(0);
    {
        EdgeThread thread(QStringLiteral("edge"), std::make_unique<Inside>(destroyedOn));
        thread.post([&] {
            go.acquire();
            ranOn = QThread::currentThread();
        });
        for (int i = 0; i < 3; ++i) {
            thread.post([&, i] { jobs.push_back(i); });
        }
        EXPECT_THAT(jobs, ElementsAre()) << "the first job still waits";
        go.release();
    }
    EXPECT_THAT(jobs, ElementsAre(0, 1, 2)) << "what was posted is done before the end";
    EXPECT_NE(ranOn, QThread::currentThread());
    EXPECT_EQ(destroyedOn, ranOn);
}

}  // namespace
}  // namespace boresight

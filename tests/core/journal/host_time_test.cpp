// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/host_time.h"

#include "tests/fakes/manual_clock.h"

#include <QFile>

#include <gtest/gtest.h>

namespace boresight::journal {
namespace {

TEST(HostTime, IsTheKernelsRunAndTheInjectedSteadyTime)
{
    QFile file(QStringLiteral("/proc/sys/kernel/random/boot_id"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    fakes::ManualClock clock;
    const HostTime before = hostTime(clock);
    EXPECT_EQ(before.boot.toLatin1() + '\n', file.readAll());
    EXPECT_EQ(before.boot.size(), 36);
    clock.advance(Seconds(12.5));
    const HostTime after = hostTime(clock);
    EXPECT_EQ(after.boot, before.boot);
    EXPECT_DOUBLE_EQ((after.sinceBoot - before.sinceBoot).count(), 12.5);
}

}  // namespace
}  // namespace boresight::journal

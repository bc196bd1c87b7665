// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/stream_log.h"

#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// Story: during a pass Gpredict caused a log line for each position, 600 in ten minutes, on a small flash.
// REQ-MEMORY-952: The first accepted position of a client is a line in the log. The others are counted. One line a
// minute gives their number and the last position, and so does a line at the end of the client.
TEST(StreamLog, PositionsOfAClientAreSummedUp)
{
    const QString client = QStringLiteral("rotctld 1");
    fakes::ManualClock clock;
    EventLog log(clock);
    StreamLog stream(log, clock, StreamLog::Answer::Accepted);
    EXPECT_TRUE(stream.begins(client, QStringLiteral("P 0.00 10.00")));
    for (int second = 1; second <= 90; ++second) {
        clock.advance(Seconds(1.0));
        EXPECT_FALSE(stream.begins(client, QStringLiteral("P %1.00 10.00").arg(second)));
    }
    EXPECT_TRUE(stream.begins(QStringLiteral("rotctld 2"), QStringLiteral("P 5.00 5.00"))) << "each has its own";
    ASSERT_EQ(log.since(0, 10).size(), 1u);
    EXPECT_EQ(log.since(0, 10).back().text, QStringLiteral("60 more accepted in 60 s. The last: P 60.00 10.00"));
    stream.gone(client);
    EXPECT_EQ(log.since(0, 10).back().text, QStringLiteral("30 more accepted in 30 s. The last: P 90.00 10.00"));
    stream.gone(QStringLiteral("rotctld 2"));
    EXPECT_EQ(log.since(0, 10).size(), 2u) << "its only one has its own line";
}

// REQ-MEMORY-952
TEST(StreamLog, AfterAMinuteOfSilenceAStreamBeginsAnew)
{
    const QString client = QStringLiteral("rotctld 1");
    fakes::ManualClock clock;
    EventLog log(clock);
    StreamLog stream(log, clock, StreamLog::Answer::Accepted);
    EXPECT_TRUE(stream.begins(client, QStringLiteral("P 0.00 10.00")));
    clock.advance(Seconds(60.0));
    EXPECT_TRUE(stream.begins(client, QStringLiteral("P 1.00 10.00")));
}

// Story: a client that kept sending while STOP was latched caused a line each second, because its numbers changed.
// REQ-MEMORY-953: Refused positions of a client are summed up in the same way while the reason stays the same.
TEST(StreamLog, RefusedPositionsAreSummedUpByTheirReason)
{
    const QString client = QStringLiteral("rotctld 1");
    const QString stopped = QStringLiteral("STOP is latched");
    fakes::ManualClock clock;
    EventLog log(clock);
    StreamLog stream(log, clock, StreamLog::Answer::Refused);
    EXPECT_TRUE(stream.begins(client, QStringLiteral("P 0.00 10.00"), stopped));
    for (int second = 1; second <= 5; ++second) {
        clock.advance(Seconds(1.0));
        EXPECT_FALSE(stream.begins(client, QStringLiteral("P %1.00 10.00").arg(second), stopped));
    }
    EXPECT_TRUE(stream.begins(client, QStringLiteral("P 6.00 10.00"), QStringLiteral("no reply")));
    ASSERT_EQ(log.since(0, 10).size(), 1u);
    EXPECT_EQ(log.since(0, 10).back().text, QStringLiteral("5 more refused in 5 s. The last: P 5.00 10.00"));
    EXPECT_EQ(log.since(0, 10).back().severity, Severity::Warning);
}

}  // namespace
}  // namespace boresight

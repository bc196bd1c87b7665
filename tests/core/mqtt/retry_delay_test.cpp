// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/retry_delay.h"

#include <gtest/gtest.h>

#include <vector>

namespace boresight::mqtt {
namespace {

// REQ-MQTT-04 (MqttRetryDelay.*): A connection is tried again after 1, 2, 4, 8, 16, 30, 30… s. After a connection that
// lasted 10 s the delay starts again at 1 s.
TEST(MqttRetryDelay, GrowsToHalfAMinuteAndBeginsAnew)
{
    RetryDelay delay;
    std::vector<long> seconds;
    for (int i = 0; i < 8; ++i) {
        seconds.push_back(delay.next().count());
    }
    EXPECT_EQ(seconds, (std::vector<long>{1, 2, 4, 8, 16, 30, 30, 30}));
    delay.reset();
    EXPECT_EQ(delay.next(), std::chrono::seconds(1));
}

}  // namespace
}  // namespace boresight::mqtt

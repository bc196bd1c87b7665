// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_position.h"

#include "core/position/position_feed.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

// REQ-POSITION-23: A refused position is a line in the log, at most one each second. A position with another call sign
// is not logged, because other stations use the same channel.
TEST(StationPosition, AnotherCallSignIsNotLogged)
{
    fakes::ManualClock clock;
    EventLog log{clock};
    profile::InForce inForce{profile::Profile{}};
    StationBroker broker(inForce, log, clock, nullptr);
    StationPosition position(inForce, log, clock, broker, nullptr);
    position::PositionFeed feed;
    feed.setLimits({.name = QStringLiteral("V2850795")});
    const auto tell = [&](const char* text) {
        position.tellRefused(feed.take(position::readPosition(text), clock.now(), clock.utc()).error());
    };
    tell(R"({"callsign":"X1","latitude":46.5,"longitude":13.1,"altitude":210})");
    EXPECT_TRUE(log.since(0, 10).empty());
    EXPECT_EQ(feed.refused(), 1U);
    tell("0,0,0");
    tell("0,0,1");
    ASSERT_EQ(log.since(0, 10).size(), 1U);
    EXPECT_EQ(log.since(0, 10).front().text,
              QStringLiteral("a position was refused: latitude and longitude are 0, as without a GPS fix"));
    EXPECT_EQ(log.since(0, 10).front().severity, Severity::Warning);
}

}  // namespace
}  // namespace boresight

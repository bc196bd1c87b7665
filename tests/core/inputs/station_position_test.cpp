// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_position.h"

#include "core/position/position_feed.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QUdpSocket>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

// REQ-POSITION-20: A datagram is one position: a line or a JSON object. An unreadable datagram is reported with the
// reason.
TEST(StationPosition, ADatagramIsOnePosition)
{
    fakes::ManualClock clock;
    EventLog log{clock};
    profile::Profile profile;
    profile.position = {.source = profile::PositionSource::Udp, .port = fakes::unusedUdpPort()};
    profile::InForce inForce{profile};
    StationBroker broker(inForce, log, clock, nullptr);
    StationPosition position(inForce, log, clock, broker, nullptr);
    std::vector<Result<position::PositionText>> all;
    QObject::connect(&position, &StationPosition::received, &position, [&](const auto& read) { all.push_back(read); });
    position.open();
    QUdpSocket sender;
    const auto send = [&](const QByteArray& bytes) {
        sender.writeDatagram(bytes, QHostAddress::LocalHost, static_cast<std::uint16_t>(profile.position.port));
    };
    ASSERT_TRUE(fakes::waitUntil([&] {
        send("38.757,-9.117,1200\n");
        return !all.empty();
    }));
    send(QByteArray(60'000, ' ') + "1,1,1");
    send(R"({"type":"PAYLOAD_SUMMARY","callsign":"X1","latitude":46.25,"longitude":13.5,"altitude":1001.8})");
    const auto isSonde = [](const auto& read) { return read && read->name == QStringLiteral("X1"); };
    ASSERT_TRUE(fakes::waitUntil([&] { return std::ranges::any_of(all, isSonde); }));
    EXPECT_EQ(std::ranges::count_if(all, [](const auto& read) { return !read; }), 1);
    EXPECT_EQ(all.front()->site.latitude, Angle::fromDegrees(38.757));
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of the wind by UDP, and the reaction of the station.
#include "core/inputs/station_wind.h"

#include "tests/core/station/moving_station.h"
#include "tests/fakes/unused_port.h"

#include <QTemporaryDir>
#include <QUdpSocket>

#include <gtest/gtest.h>

namespace boresight {
namespace {

class StationWindTest : public ::testing::Test
{
protected:
    StationWindTest()
    {
        profile::Profile profile = anyPort();
        profile.park = {.azimuth = 20_deg, .elevation = 10_deg};
        profile.wind.source = "udp:" + std::to_string(port);
        station().reload(profile);
    }
    Station& station() { return *moving.station; }
    void send(const QByteArray& text) { sender.writeDatagram(text, QHostAddress::LocalHost, port); }
    [[nodiscard]] bool arrives(const QByteArray& text, double speed)
    {
        return fakes::waitUntil([&] {
            send(text);
            return moving.station->status().wind.speed == speed;
        });
    }
    // The clock is turned at once after the readings, so that the last reading is still recent.
    void blow(const QByteArray& text, Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(5.0)) {
            const std::uint64_t before = station().status().wind.accepted;
            ASSERT_TRUE(fakes::waitUntil([&] {
                send(text);
                return station().status().wind.accepted > before;
            }));
            moving.run(Seconds(5.0));
        }
    }

    std::uint16_t port = fakes::unusedUdpPort();
    QUdpSocket sender;
    QTemporaryDir folder;
    MovingStation moving{folder.path()};
};

// REQ-WIND-40: Readings by UDP reach the station: the status has the wind and its age, and a strong wind parks the
// mount.
TEST_F(StationWindTest, AReadingByUdpParksTheMount)
{
    ASSERT_TRUE(arrives("wind 4.5\n", 4.5));
    moving.run(Seconds(2.0));
    EXPECT_GE(station().status().wind.age, Seconds(1.9));
    EXPECT_LE(station().status().wind.age, Seconds(2.1));
    EXPECT_EQ(station().status().wind.source, QStringLiteral("udp:%1").arg(port));
    station().request({.id = 1, .request = request::PointAxes{{.azimuth = 60_deg, .elevation = 40_deg}}});
    blow("4.5", Seconds(30.0));
    ASSERT_EQ(station().status().state, StationState::Hold);
    blow(R"({"wind": 21.0})", Seconds(60.0));
    const StationStatus status = station().status();
    EXPECT_EQ(status.state, StationState::Parked);
    EXPECT_EQ(status.wind.obstacle, QStringLiteral("The wind reached 21.0 m/s. The limit is 15.0 m/s."));
    EXPECT_NEAR(status.azimuth.actual->degrees(), 20.0, 0.2);
}

// REQ-WIND-41: A text that is no reading is counted, with the reason of the last one. It does not change the wind.
TEST_F(StationWindTest, RubbishIsCounted)
{
    ASSERT_TRUE(arrives("4.5", 4.5));
    ASSERT_TRUE(fakes::waitUntil([&] {
        send("storm");
        return station().status().wind.refused > 0;
    }));
    EXPECT_EQ(station().status().wind.refusal, QStringLiteral("the wind speed is not a number"));
    EXPECT_EQ(station().status().wind.speed, 4.5);
}

}  // namespace
}  // namespace boresight

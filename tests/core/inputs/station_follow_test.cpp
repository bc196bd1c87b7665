// SPDX-License-Identifier: GPL-3.0-or-later
// From the rotctld of another rotator to the simulated mount.
#include "core/profile/setting.h"
#include "core/units/angle_between.h"
#include "tests/core/station/moving_station.h"
#include "tests/fakes/playing_rotctld.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

class StationFollowTest : public testing::Test
{
protected:
    std::string refusalOf(std::uint64_t id, const QString& name)
    {
        rig.station->request({.id = id, .request = request::FollowRotator{name}});
        const auto answer = rig.answerTo(id);
        return answer && answer->error ? textOf(*answer->error) : std::string();
    }
    bool isAt(const SkyPointing& place)
    {
        return fakes::waitUntil([&] {
            rig.run(Seconds(0.1));
            const auto actual = rig.station->status().actual;
            return actual && angleBetween(*actual, place) < 0.1_deg;
        });
    }

    QTemporaryDir folder;
    MovingStation rig{folder.path()};
    fakes::PlayingRotctld other;
};

// REQ-STATION-960: The request is answered when the other rotator has reported its position. Then the mount follows it.
// When its rotctld is gone the mount holds, and does not resume when the rotctld is back.
TEST_F(StationFollowTest, TheMountFollowsAnotherRotator)
{
    other.answer = "20.000000\n25.000000\n";
    EXPECT_EQ(refusalOf(1, other.name()), "");
    ASSERT_TRUE(rig.station->status().tracked);
    EXPECT_TRUE(isAt({20_deg, 25_deg}));
    other.answer = "24.000000\n27.000000\n";
    EXPECT_TRUE(isAt({24_deg, 27_deg}));
    other.answer.clear();
    ASSERT_TRUE(fakes::waitUntil([&] {
        rig.run(Seconds(0.1));
        return !rig.station->status().tracked;
    }));
    other.answer = "60.000000\n50.000000\n";
    rig.run(Seconds(10.0));
    EXPECT_LT(angleBetween(*rig.station->status().actual, {24_deg, 27_deg}), 0.5_deg);
}

// REQ-STATION-961: An invalid name, the station's own server and a rotctld that does not answer are refused with the
// reason. Hold ends the waiting and the following.
TEST_F(StationFollowTest, RefusesWithTheReason)
{
    EXPECT_THAT(refusalOf(1, QStringLiteral("rotctld:nowhere")), HasSubstr("names no rotctld"));
    EXPECT_THAT(refusalOf(2, QStringLiteral("tcp:10.0.0.7:4533")), HasSubstr("names no rotctld"));
    other.answer.clear();
    EXPECT_THAT(refusalOf(3, other.name()), HasSubstr("does not answer"));
    rig.station->request({.id = 4, .request = request::FollowRotator{other.name()}});
    rig.station->request({.id = 5, .request = request::Hold{}});
    const auto overtaken = rig.answerTo(4);
    ASSERT_TRUE(overtaken && overtaken->error);
    EXPECT_THAT(textOf(*overtaken->error), HasSubstr("Another command came"));
    EXPECT_FALSE(rig.station->status().tracked);

    rig.station->request({.id = 8, .request = request::FollowRotator{other.name()}});
    rig.station->request({.id = 9, .request = request::TrackFile{QStringLiteral("/nowhere.csv")}});
    const auto older = rig.answerTo(8);
    ASSERT_TRUE(older && older->error);
    EXPECT_THAT(textOf(*older->error), HasSubstr("Another command came"));

    other.answer = "20\n25\n";
    EXPECT_EQ(refusalOf(6, other.name()), "");
    rig.run(Seconds(1.0));
    rig.station->request({.id = 7, .request = request::Hold{}});
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.station->status().tracked);
}

// REQ-STATION-964: If a request for another rotator fails, the mount keeps following the present one.
TEST_F(StationFollowTest, ARefusedOneChangesNothing)
{
    other.answer = "20\n25\n";
    ASSERT_EQ(refusalOf(1, other.name()), "");
    fakes::PlayingRotctld silent;
    silent.answer.clear();
    EXPECT_THAT(refusalOf(2, silent.name()), HasSubstr("does not answer"));
    rig.run(Seconds(1.0));
    other.answer = "23\n26\n";
    EXPECT_TRUE(isAt({23_deg, 26_deg}));
}

// REQ-STATION-962: The station does not follow itself under any of its names.
TEST(OwnServer, IsKnownByEachOfItsNames)
{
    const auto own = [](const char* bus, const char* listens) {
        return profile::isOwnServer(*parseBusName(bus), *profile::parseListenAddress(listens));
    };
    EXPECT_TRUE(own("rotctld:127.0.0.1:4533", "127.0.0.1:4533"));
    EXPECT_TRUE(own("rotctld:localhost:4533", "0.0.0.0:4533"));
    EXPECT_TRUE(own("rotctld:10.0.0.5:4533", "10.0.0.5:4533"));
    EXPECT_FALSE(own("rotctld:127.0.0.1:4534", "127.0.0.1:4533"));
    EXPECT_FALSE(own("rotctld:10.0.0.7:4533", "127.0.0.1:4533"));
    EXPECT_FALSE(own("tcp:127.0.0.1:4533", "127.0.0.1:4533"));
}

}  // namespace
}  // namespace boresight

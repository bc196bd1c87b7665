// SPDX-License-Identifier: GPL-3.0-or-later
// Real sockets. The clock is turned by hand.
#include "core/followed_rotctld/followed_rotctld.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/playing_rotctld.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <vector>

namespace boresight::rotctl {
namespace {

using testing::HasSubstr;

class FollowedRotctldTest : public testing::Test
{
protected:
    void begin(const BusName& bus)
    {
        reports.clear();
        followed = std::make_unique<FollowedRotctld>(bus, clock.now());
        QObject::connect(followed.get(), &FollowedRotctld::read,
                         [this](const RotatorReport& report) { reports.push_back(report); });
    }
    // Ticks once for each check of the condition.
    bool comesTrue(const std::function<bool()>& condition, Seconds step = Seconds(0.02))
    {
        return fakes::waitUntil([&] {
            clock.advance(step);
            followed->tick(clock.now());
            return condition();
        });
    }
    bool isFound()
    {
        begin(rotctld.bus());
        return comesTrue([this] { return !reports.empty(); }, Seconds(0.0)) && reports.front().direction;
    }
    // The reason why it was given up.
    std::string problem(const BusName& bus, Seconds step = Seconds(0.02))
    {
        begin(bus);
        EXPECT_TRUE(comesTrue([this] { return !reports.empty(); }, step));
        return reports.empty() || reports.front().direction ? std::string() : textOf(reports.front().direction.error());
    }

    fakes::ManualClock clock;
    fakes::PlayingRotctld rotctld;
    std::vector<RotatorReport> reports;
    std::unique_ptr<FollowedRotctld> followed;
};

// REQ-ROTATORFOLLOW-10: Each position is reported as it was received. Only p is sent.
TEST_F(FollowedRotctldTest, ReadsAgainAndAgain)
{
    ASSERT_TRUE(isFound());
    EXPECT_EQ(reports.front().name, rotctld.name());
    EXPECT_EQ(*reports.front().direction, (SkyPointing{120_deg, 30_deg}));
    rotctld.answer = "370.5\n31\n";
    ASSERT_TRUE(comesTrue([this] { return reports.size() >= 4 && reports.back().direction->elevation == 31_deg; }));
    EXPECT_EQ(reports.back().direction->azimuth, 370.5_deg);
    rotctld.heard.replace("p\n", "");
    EXPECT_EQ(rotctld.heard, "");
}

// REQ-ROTATORFOLLOW-11: A rotctld that never reports a position is given up with the reason: nothing listens, the
// rotator does not answer, or the server is no rotctld.
TEST_F(FollowedRotctldTest, SaysWhyThereIsNoPosition)
{
    EXPECT_THAT(problem({.kind = BusKind::Rotctld, .target = "127.0.0.1", .port = fakes::unusedPort()}, Seconds(0.0)),
                HasSubstr("Connection refused. Check that rotctld runs there."));
    rotctld.answer = "RPRT -5\n";
    EXPECT_THAT(problem(rotctld.bus()), HasSubstr("the rotator did not answer rotctld in time (RPRT -5)"));
    rotctld.answer.clear();
    EXPECT_EQ(problem(rotctld.bus()), rotctld.name().toStdString() + " does not answer");
    rotctld.answer = "HTTP/1.1 400 Bad Request\r\n\r\n";
    EXPECT_THAT(problem(rotctld.bus()), HasSubstr("is not from a rotctld"));
}

// REQ-ROTATORFOLLOW-12: A connection that ends is made again. After 5 s without a position the rotctld is finally given
// up, with the reason.
TEST_F(FollowedRotctldTest, ConnectsAgainAndThenGivesUp)
{
    ASSERT_TRUE(isFound());
    rotctld.dropAll();
    reports.clear();
    ASSERT_TRUE(comesTrue([this] { return rotctld.connections() == 2 && !reports.empty(); }));
    EXPECT_TRUE(reports.front().direction);
    rotctld.vanish();
    ASSERT_TRUE(comesTrue([this] { return !reports.back().direction; }, Seconds(0.1)));
    EXPECT_THAT(textOf(reports.back().direction.error()), HasSubstr("Check that rotctld runs there."));
    const std::size_t before = reports.size();
    const SteadyTime gone = clock.now();
    EXPECT_TRUE(comesTrue([&] { return clock.now() - gone > Seconds(30.0); }, Seconds(0.5)));
    EXPECT_EQ(reports.size(), before);
}

}  // namespace
}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
// With real sockets; the clock is turned by hand.
#include "core/followed_rotctld/followed_rotctld.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/playing_rotctld.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <gmock/gmock.h>

#include <functional>
#include <optional>
#include <vector>

namespace boresight::rotctl {
namespace {

using testing::HasSubstr;

class FollowedRotctldTest : public testing::Test
{
protected:
    FollowedRotctldTest()
    {
        QObject::connect(&followed, &FollowedRotctld::read,
                         [this](const RotatorReading& reading) { read.push_back(reading); });
    }
    void find(const BusName& bus)
    {
        followed.find(bus, clock.now(), [this](const Result<RotatorReading>& answered) { first = answered; });
    }
    // A tick for each look of the test.
    bool comesTrue(const std::function<bool()>& condition, Seconds step = Seconds(0.02))
    {
        return fakes::waitUntil([&] {
            clock.advance(step);
            followed.tick(clock.now());
            return condition();
        });
    }
    bool isFound()
    {
        find(rotctld.bus());
        return comesTrue([this] { return first.has_value(); }, Seconds(0.0)) && *first;
    }
    [[nodiscard]] std::string problem() const { return first && !*first ? textOf(first->error()) : std::string(); }

    fakes::ManualClock clock;
    fakes::PlayingRotctld rotctld;
    FollowedRotctld followed;
    std::optional<Result<RotatorReading>> first;
    std::vector<RotatorReading> read;
};

// REQ-ROTATORFOLLOW-10: Who asks gets the first position, and the signal all others. Nothing is sent but p.
TEST_F(FollowedRotctldTest, ReadsAgainAndAgain)
{
    ASSERT_TRUE(isFound());
    EXPECT_EQ((*first)->name, rotctld.name());
    EXPECT_EQ((*first)->direction, (SkyPointing{120_deg, 30_deg}));
    rotctld.answer = "370.5\n31\n";
    ASSERT_TRUE(comesTrue([this] { return read.size() >= 3 && read.back().direction.elevation == 31_deg; }));
    EXPECT_EQ(read.back().direction.azimuth, 370.5_deg);
    rotctld.heard.replace("p\n", "");
    EXPECT_EQ(rotctld.heard, "");
    followed.close();
    const std::size_t before = read.size();
    for (int i = 0; i < 100; ++i) {
        clock.advance(Seconds(0.1));
        followed.tick(clock.now());
    }
    EXPECT_EQ(read.size(), before);
}

// REQ-ROTATORFOLLOW-11: Who waits for the first position hears why there is none: nobody listens, the rotator does not
// answer, the server is none, another command came.
TEST_F(FollowedRotctldTest, SaysWhyThereIsNoPosition)
{
    find({.kind = BusKind::Rotctld, .target = "127.0.0.1", .port = fakes::unusedPort()});
    ASSERT_TRUE(comesTrue([this] { return first.has_value(); }, Seconds(0.0)));
    EXPECT_THAT(problem(), HasSubstr("Connection refused. Check that rotctld runs there."));

    first.reset();
    rotctld.answer = "RPRT -5\n";
    find(rotctld.bus());
    ASSERT_TRUE(comesTrue([this] { return first.has_value(); }));
    EXPECT_THAT(problem(), HasSubstr("the rotator did not answer rotctld in time (RPRT -5)"));

    first.reset();
    rotctld.answer.clear();
    find(rotctld.bus());
    ASSERT_TRUE(comesTrue([this] { return first.has_value(); }));
    EXPECT_EQ(problem(), rotctld.name().toStdString() + " does not answer");

    first.reset();
    rotctld.answer = "HTTP/1.1 400 Bad Request\r\n\r\n";
    find(rotctld.bus());
    ASSERT_TRUE(comesTrue([this] { return first.has_value(); }));
    EXPECT_THAT(problem(), HasSubstr("is not that of a rotctld"));

    first.reset();
    find(rotctld.bus());
    followed.forget();
    EXPECT_THAT(problem(), HasSubstr("Another command came"));
    first.reset();
    followed.forget();
    EXPECT_FALSE(first) << "answered once";
}

// REQ-ROTATORFOLLOW-12: A connection that ends, or that hangs, is made anew. After 5 s without a position it is given
// up for good.
TEST_F(FollowedRotctldTest, ConnectsAgainAndThenGivesUp)
{
    ASSERT_TRUE(isFound());
    rotctld.dropAll();
    ASSERT_TRUE(comesTrue([this] { return rotctld.connections() == 2 && !read.empty(); }));
    rotctld.vanish();
    const SteadyTime gone = clock.now();
    const auto isOver = [&] { return clock.now() - gone > FollowedRotctld::kLongestSilence + Seconds(1.0); };
    ASSERT_TRUE(comesTrue(isOver, Seconds(0.1)));
    const std::size_t before = read.size();
    EXPECT_TRUE(comesTrue([&] { return clock.now() - gone > Seconds(30.0); }, Seconds(0.5)));
    EXPECT_EQ(read.size(), before);
}

}  // namespace
}  // namespace boresight::rotctl

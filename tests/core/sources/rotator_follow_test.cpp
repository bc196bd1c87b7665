// SPDX-License-Identifier: GPL-3.0-or-later
// The mount follows another rotator.
#include "core/sources/rotator_follow.h"

#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;

const QString kOther = QStringLiteral("rotctld:10.0.0.7:4533");

class RotatorFollowTest : public testing::Test
{
protected:
    RotatorFollowTest() { rig.run(Seconds(0.2)); }

    // The other rotator turns by 0.5°/s, and is read four times a second.
    [[nodiscard]] SkyPointing direction() const
    {
        const Angle turned = Angle::fromDegrees(0.5 * Seconds(rig.clock.now() - m_start).count());
        return {.azimuth = 40_deg + turned, .elevation = 30_deg};
    }
    Result<> report(const QString& name = kOther)
    {
        return rig.control.receive(RotatorReport{.name = name, .direction = direction()});
    }
    void turn(Seconds time, bool isReporting = true)
    {
        for (int i = 0; i < static_cast<int>(time / rig.step); ++i) {
            if (isReporting && i % 12 == 0) {
                (void)report();
            }
            rig.tick();
        }
    }
    std::string ask(const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request::FollowRotator{kOther}, by);
        return answer ? std::string() : textOf(answer.error());
    }
    void follow()
    {
        (void)report();
        ASSERT_EQ(ask(), "");
        turn(Seconds(30.0));
        ASSERT_LT(off(), 0.3_deg);
    }
    [[nodiscard]] Angle off() const
    {
        return angleBetween(rig.control.status().actual.value_or(SkyPointing{}), direction());
    }
    [[nodiscard]] std::string alarm() const
    {
        const auto list = rig.alarms.list();
        const auto found = std::ranges::find_if(
            list, [](const Alarm& one) { return one.active && one.name == QLatin1String("followed.ended"); });
        return found == list.end() ? std::string() : found->what.toStdString();
    }

    StationRig rig;

private:
    SteadyTime m_start = rig.clock.now();
};

// REQ-ROTATORFOLLOW-20: The mount points where another rotator points, and moves with it. The header names that
// rotator.
TEST_F(RotatorFollowTest, PointsWhereTheOtherPoints)
{
    follow();
    Angle worst;
    for (int i = 0; i < 30; ++i) {
        turn(Seconds(1.0));
        worst = std::max(worst, off());
    }
    EXPECT_LT(worst, 0.3_deg);
    EXPECT_EQ(rig.control.status().tracked.value().name, kOther);
    EXPECT_EQ(rig.control.status().state, StationState::Track);
    EXPECT_TRUE(report()) << "it is wanted";
    EXPECT_FALSE(report(QStringLiteral("rotctld:10.0.0.8:4533"))) << "of another one";
}

// REQ-ROTATORFOLLOW-21: Without a position for 6 s the tracking ends with an alarm, and the mount holds. It does not
// resume by itself.
TEST_F(RotatorFollowTest, ASilenceEndsIt)
{
    follow();
    turn(Seconds(6.5), false);
    EXPECT_THAT(alarm(), HasSubstr("no longer tracks another rotator: no position was received for 6 s"));
    turn(Seconds(3.0), false);
    const auto place = rig.control.status().actual;
    turn(Seconds(20.0));
    EXPECT_LT(angleBetween(*place, *rig.control.status().actual), 0.02_deg);
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_FALSE(report()) << "nobody wants it";
    EXPECT_EQ(ask(), "");
    turn(Seconds(1.0));
    EXPECT_EQ(alarm(), "");
}

// REQ-ROTATORFOLLOW-24: The reader of the positions reports why there are no more. A position that is more than 10°
// away after a gap ends the tracking, too, and the mount does not go there.
TEST_F(RotatorFollowTest, EndsWithTheReason)
{
    follow();
    EXPECT_TRUE(rig.control.receive(
        RotatorReport{.name = kOther, .direction = failure(ErrorCode::NoAnswer, QStringLiteral("It is gone."))}));
    turn(Seconds(0.1), false);
    EXPECT_THAT(alarm(), HasSubstr("It is gone."));

    follow();
    turn(Seconds(1.5), false);
    (void)rig.control.receive(RotatorReport{.name = kOther, .direction = SkyPointing{0_deg, 0_deg}});
    const auto place = rig.control.status().actual;
    turn(Seconds(3.0), false);
    EXPECT_THAT(alarm(), HasSubstr("from the last position"));
    EXPECT_LT(angleBetween(*place, *rig.control.status().actual), 1_deg);
}

// REQ-ROTATORFOLLOW-25: If another rotator is queried meanwhile, its position is not taken for that of the followed
// rotator.
TEST_F(RotatorFollowTest, AnotherOneIsNotTakenForIt)
{
    follow();
    const QString next = QStringLiteral("rotctld:10.0.0.8:4533");
    EXPECT_FALSE(rig.control.receive(RotatorReport{.name = next, .direction = SkyPointing{5_deg, 60_deg}}));
    turn(Seconds(2.0));
    EXPECT_LT(off(), 0.3_deg);
    EXPECT_FALSE(rig.ask(request::FollowRotator{QStringLiteral("rotctld:10.0.0.9:4533")}));
    turn(Seconds(2.0));
    EXPECT_LT(off(), 0.3_deg);
    EXPECT_FALSE(rig.control.receive(RotatorReport{.name = next, .direction = SkyPointing{50_deg, 35_deg}}));
    EXPECT_TRUE(rig.ask(request::FollowRotator{next}));
    EXPECT_EQ(rig.control.status().tracked.value().name, next);
    EXPECT_FALSE(report()) << "the one before is not wanted any more";
}

// REQ-ROTATORFOLLOW-22: The rules of every motion apply: following is refused without a position, for a client, and
// while STOP is latched. Any other motion ends it.
TEST_F(RotatorFollowTest, PassesTheGates)
{
    EXPECT_EQ(ask(), "No position of rotctld:10.0.0.7:4533 was received");
    (void)report();
    EXPECT_NE(ask(kClient), "");
    EXPECT_TRUE(rig.ask(request::Stop{}));
    EXPECT_THAT(ask(), HasSubstr("STOP is latched"));
    for (const Request& other : {Request(request::Hold{}), Request(request::Stop{}), Request(request::Park{}),
                                 Request(request::PointSky{{.azimuth = 10_deg, .elevation = 20_deg}})}) {
        (void)rig.ask(request::ResetStop{});
        (void)report();
        ASSERT_EQ(ask(), "");
        turn(Seconds(1.0));
        EXPECT_TRUE(rig.control.status().tracked);
        EXPECT_TRUE(rig.ask(other));
        turn(Seconds(5.0));
        EXPECT_FALSE(rig.control.status().tracked);
        EXPECT_FALSE(report());
    }
    EXPECT_EQ(alarm(), "") << "it was ended by hand";
}

// REQ-ROTATORFOLLOW-23: The limits of this mount hold, wherever the other rotator points.
TEST(RotatorFollow, TheLimitsHold)
{
    profile::Profile profile;
    profile.elevation.geometry.travel = {.min = 0_deg, .max = 20_deg};
    StationRig low(profile);
    low.run(Seconds(0.2));
    const RotatorReport high{.name = kOther, .direction = SkyPointing{.azimuth = 40_deg, .elevation = 30_deg}};
    (void)low.control.receive(high);
    (void)low.ask(request::FollowRotator{kOther});
    for (int i = 0; i < 40; ++i) {
        (void)low.control.receive(high);
        low.run(Seconds(0.5));
        EXPECT_LT(low.control.status().actual.value_or(SkyPointing{}).elevation.degrees(), 20.1);
    }
}

}  // namespace
}  // namespace boresight

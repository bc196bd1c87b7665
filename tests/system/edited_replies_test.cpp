// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>

// One in ten replies is changed on the wire: wrong, unset, infinite, missing, stale, doubled, exchanged, under another
// id, without voltage or temperature. The antenna stands, goes to a client's target, tracks a stream and is jogged.
// This lasts BORESIGHT_EDITED_MINUTES of mount time (by default an hour, less with the sanitizers). Every tick is
// judged by the true position of the antenna. One seed determines the changes and the requests.
namespace boresight::system_test {
namespace {

#ifdef BORESIGHT_SANITIZED
constexpr double kUsualMinutes = 10.0;
#else
constexpr double kUsualMinutes = 60.0;
#endif
constexpr double kShare = 0.1;
constexpr Seconds kPoint{1.0};  // between two targets of the client's stream
constexpr Seconds kCatchUp{8.0};
constexpr Seconds kKeepAlive{0.1};
constexpr Angle kOutside = Angle::fromDegrees(0.2);
constexpr Angle kStands = Angle::fromDegrees(0.3);
constexpr Angle kArrives = Angle::fromDegrees(0.1);
constexpr Angle kFollows = Angle::fromDegrees(1.0);

double minutes()
{
    const char* const given = std::getenv("BORESIGHT_EDITED_MINUTES");
    return given != nullptr ? parseFinite(given).value_or(kUsualMinutes) : kUsualMinutes;
}

std::string point(const AxisPosition& at)
{
    return "P " + std::to_string(at.azimuth.wrapped360().degrees()) + " " + std::to_string(at.elevation.degrees()) +
           "\n";
}

class EditedReplies : public ::testing::Test
{
protected:
    EditedReplies()
    {
        rig.link->inject({.kind = sim::FaultKind::EditedReply, .value = kShare});
        rig.onTick = [this] { judge(); };
    }

    void stand(Seconds time)
    {
        m_standsAt = rig.truth();
        rig.run(time);
        m_standsAt.reset();
    }
    void goTo()
    {
        const AxisPosition place{.azimuth = degrees(-60.0, 420.0), .elevation = degrees(5.0, 85.0)};
        ask(point(place));
        EXPECT_TRUE(rig.settle(Seconds(60.0)));
        EXPECT_LT(abs((rig.truth().azimuth - place.azimuth).wrapped180()), kArrives);
        EXPECT_LT(abs(rig.truth().elevation - place.elevation), kArrives);
    }
    // A straight path across the sky, away from the ends of the travel.
    void stream(Seconds time)
    {
        const AxisPosition from{.azimuth = degrees(120.0, 240.0), .elevation = degrees(30.0, 60.0)};
        const AxisPosition perSecond{.azimuth = degrees(-2.0, 2.0), .elevation = degrees(-0.4, 0.4)};
        const auto at = [&](Seconds passed) {
            return AxisPosition{.azimuth = from.azimuth + passed.count() * perSecond.azimuth,
                                .elevation = from.elevation + passed.count() * perSecond.elevation};
        };
        ask(point(from));
        EXPECT_TRUE(rig.settle(Seconds(60.0)));
        for (Seconds passed{0.0}; passed < time; passed += kPoint) {
            ask(point(at(passed)));
            rig.run(kPoint);
            if (passed > kCatchUp) {
                const AxisPosition wanted = at(passed + kPoint);
                const Angle apart = std::max(abs((rig.truth().azimuth - wanted.azimuth).wrapped180()),
                                             abs(rig.truth().elevation - wanted.elevation));
                m_followed = std::max(m_followed, apart);
            }
        }
        ask("S\n");
        EXPECT_TRUE(rig.settle());
    }
    void jog(Seconds time)
    {
        const AxisRates rates{.azimuth = AngularRate::fromDegrees(random(-5.0, 5.0)),
                              .elevation = AngularRate::fromDegrees(random(-3.0, 3.0))};
        for (Seconds passed{0.0}; passed < time; passed += kKeepAlive) {
            EXPECT_EQ(rig.ask(request::Jog{rates}), "");
            rig.run(kKeepAlive);
        }
        EXPECT_EQ(rig.ask(request::Jog{}), "");
        EXPECT_TRUE(rig.settle());
        EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
    }
    void expectNothingBad()
    {
        std::printf(
            "  outside %.3f deg, stood within %.3f deg, followed within %.3f deg, fastest %.3f of the limit, "
            "%d requests\n",
            m_outside.degrees(), m_strayed.degrees(), m_followed.degrees(), m_fastest, m_requests);
        EXPECT_LT(m_outside, kOutside);
        EXPECT_LT(m_strayed, kStands);
        EXPECT_LT(m_followed, kFollows);
        EXPECT_LT(m_fastest, 1.1);
        for (const auto& [alarm, count] : m_ended) {
            ADD_FAILURE() << count << " times not armed: " << alarm;
        }
    }

    SimulatedStation rig{anyPort(), sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg})};
    std::unique_ptr<fakes::TcpPeer> client{rig.connect()};

private:
    void ask(const std::string& command)
    {
        ++m_requests;
        EXPECT_EQ(client->ask(command), "RPRT 0\n") << command;
    }
    void judge()
    {
        const StationStatus status = rig.status();
        for (const Axis axis : kAxes) {
            const sim::AxisTruth now = rig.link->truth(axis);
            const TravelRange& travel = status.profile->axis(axis).geometry.travel;
            m_outside = std::max({m_outside, travel.min - now.angle, now.angle - travel.max});
            m_fastest = std::max(m_fastest, abs(now.rate) / status.profile->axis(axis).limits.speed);
        }
        if (m_standsAt) {
            m_strayed = std::max(m_strayed, rig.farthestFrom(*m_standsAt));
        }
        const bool armed = status.state != StationState::Fault && status.state != StationState::Disconnected;
        if (std::exchange(m_armed, armed) && !armed) {
            ++m_ended[status.stateReason.toStdString()];
        }
    }
    double random(double low, double high) { return std::uniform_real_distribution(low, high)(m_random); }
    Angle degrees(double low, double high) { return Angle::fromDegrees(random(low, high)); }

    std::mt19937 m_random{20261122};
    std::optional<AxisPosition> m_standsAt;
    Angle m_outside;
    Angle m_strayed;
    Angle m_followed;
    double m_fastest = 0.0;
    int m_requests = 0;
    bool m_armed = true;
    std::map<std::string, int> m_ended;
};

// REQ-SUPERVISION-19 (EditedReplies.*)
TEST_F(EditedReplies, MoveNothingBeforeTheFirstAct)
{
    stand(Seconds(60.0));
    expectNothingBad();
}

TEST_F(EditedReplies, DoNotDisturbAMountThatIsUsed)
{
    const SteadyTime end =
        rig.clock.now() + std::chrono::duration_cast<SteadyTime::duration>(Seconds(60.0 * minutes()));
    while (rig.clock.now() < end && !HasFailure()) {
        goTo();
        stand(Seconds(20.0));
        stream(Seconds(40.0));
        stand(Seconds(20.0));
        jog(Seconds(2.0));
        stand(Seconds(10.0));
    }
    expectNothingBad();
}

}  // namespace
}  // namespace boresight::system_test

// SPDX-License-Identifier: GPL-3.0-or-later
// The promises of every source of motion. The tests go through the list of sources and through all requests, so a new
// source is tested without a change here. A sample is needed below only if its default request does not move the mount.
#include "core/sources/motion_sources.h"

#include "tests/core/control/station_rig.h"
#include "tests/fakes/azel_writer.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace boresight {
namespace {

constexpr AxisRates kSlowly{.azimuth = AngularRate::fromDegrees(1.0), .elevation = AngularRate::fromDegrees(1.0)};
const QString kOtherRotator = QStringLiteral("rotctld:10.0.0.7:4533");
constexpr SkyPointing kUp{.azimuth = Angle::fromDegrees(20.0), .elevation = Angle::fromDegrees(30.0)};

// A request that moves the mount, for types whose default value does not.
template <class Wanted>
Request sampleOf()
{
    return Wanted{};
}
template <>
Request sampleOf<request::PointSky>()
{
    return request::PointSky{kUp};
}
template <>
Request sampleOf<request::PointAxes>()
{
    return request::PointAxes{{.azimuth = kUp.azimuth, .elevation = kUp.elevation}};
}
template <>
Request sampleOf<request::PointAxis>()
{
    return request::PointAxis{.axis = Axis::Azimuth, .angle = kUp.azimuth};
}
template <>
Request sampleOf<request::Follow>()
{
    return request::Follow{.direction = kUp, .what = QStringLiteral("Sun")};
}
// A satellite above the equator, as seen from the site below.
template <>
Request sampleOf<request::Track>()
{
    return request::Track{targets::satelliteTarget({.name = "FIXED",
                                                    .number = 1,
                                                    .epoch = {.day = 2461365.5, .fraction = 0.0},  // 2026-11-21
                                                    .revolutionsPerDay = 1.00273791,
                                                    .eccentricity = 1e-5,
                                                    .inclination = 0.01_deg,
                                                    .meanAnomaly = 60_deg})};
}
template <>
Request sampleOf<request::Jog>()
{
    return request::Jog{kSlowly};
}
template <>
Request sampleOf<request::Trial>()
{
    return request::Trial{kSlowly};
}
template <>
Request sampleOf<request::Move>()
{
    return request::Move{kSlowly};
}
template <>
Request sampleOf<request::Step>()
{
    return request::Step{.azimuth = kUp.azimuth};
}
template <>
Request sampleOf<request::FollowRotator>()
{
    return request::FollowRotator{kOtherRotator};
}

template <std::size_t... index>
std::vector<Request> samples(std::index_sequence<index...>)
{
    return {sampleOf<std::variant_alternative_t<index, AnyRequest>>()...};
}

const std::vector<Request>& allRequests()
{
    static const std::vector<Request> all = samples(std::make_index_sequence<std::variant_size_v<AnyRequest>>());
    return all;
}

// A mount that stands away from home and from its park position, and its sources.
struct SourcesRig
{
    SourcesRig()
    {
        rig.azimuth.position = 0.05;
        fakes::AzelWriter writer(Site{});
        for (int second = 0; second < 2; ++second) {
            (void)rig.control.receive(writer.readingAt(rig.clock.utc() + std::chrono::seconds(second)));
        }
        EXPECT_TRUE(rig.control.receive(
            position::PositionText{.site = {.latitude = 0.1_deg, .longitude = 0.2_deg, .heightMetres = 5000.0}}));
        rig.run(Seconds(0.5));
        (void)rig.control.receive(RotatorReport{.name = kOtherRotator, .direction = kUp});
    }

    static profile::Profile parkedElsewhere()
    {
        profile::Profile profile;
        profile.site = {.known = true, .latitude = 0_deg, .longitude = 0_deg};
        profile.park = {.azimuth = kUp.azimuth, .elevation = kUp.elevation};
        return profile;
    }

    MotionSources listed(Helm& helm)
    {
        MotionSources list = motionSources(helm);
        for (const auto& one : list) {
            sources.push_back(one.get());
        }
        return list;
    }

    [[nodiscard]] bool movesWithin(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= StationRig::kTick) {
            rig.tick();
            if (rig.moving()) {
                return true;
            }
        }
        return false;
    }

    std::vector<MotionSource*> sources;
    StationRig rig{parkedElsewhere(), {.trustFirstContact = true}, [this](Helm& helm) { return listed(helm); }};
};

std::string nameOf(const MotionSource& source)
{
    return typeid(source).name();
}

struct Taken
{
    std::size_t source;  // index in the list
    const Request& request;
    const Source& by;
};

// Finds the source that accepts each request of each client.
std::vector<Taken> findTaken()
{
    std::vector<Taken> taken;
    SourcesRig mount;
    for (std::size_t i = 0; i < mount.sources.size(); ++i) {
        for (const Request& request : allRequests()) {
            for (const Source* const by : {&kOperator, &kClient}) {
                if (mount.sources[i]->take(request, *by)) {
                    taken.push_back({.source = i, .request = request, .by = *by});
                }
            }
        }
    }
    return taken;
}

const std::vector<Taken>& allTaken()
{
    static const std::vector<Taken> taken = findTaken();
    return taken;
}

// Each request meets an obstacle on a separate mount, and nothing moves.
void expectRefusals(const std::function<bool(StationRig&)>& putInTheWay, const Source& by, bool butPark = false)
{
    int judged = 0;
    for (const Taken& one : allTaken()) {
        if (one.by != by || (butPark && std::holds_alternative<request::Park>(one.request))) {
            continue;
        }
        SourcesRig mount;
        ASSERT_TRUE(putInTheWay(mount.rig));
        MotionSource& source = *mount.sources[one.source];
        const auto answer = source.take(one.request, by);
        EXPECT_TRUE(answer && !*answer) << nameOf(source) << " takes request " << one.request.index();
        EXPECT_FALSE(mount.movesWithin(Seconds(0.5))) << nameOf(source);
        ++judged;
    }
    EXPECT_GT(judged, 3);
}

TEST(MotionSources, EveryRequestHasATaker)
{
    StationRig without({}, {.trustFirstContact = true}, [](Helm&) { return MotionSources(); });
    const Result<> noTaker = without.point(20.0, 30.0);
    ASSERT_FALSE(noTaker);
    for (const Request& request : allRequests()) {
        SourcesRig mount;
        const Result<> answer = mount.rig.ask(request);
        EXPECT_TRUE(answer || answer.error() != noTaker.error()) << "request " << request.index();
    }
}

TEST(MotionSources, WithoutThemNothingMoves)
{
    StationRig rig({}, {.trustFirstContact = true}, [](Helm&) { return MotionSources(); });
    rig.run(Seconds(0.5));
    const Result<> answer = rig.point(20.0, 30.0);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::NotAvailable);
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.moving());
}

// If no source could move the mount, the refusals tested below would prove nothing. A source without requests moves the
// mount by a rule of the profile.
TEST(MotionSources, EachMovesTheMount)
{
    std::set<std::size_t> asked;
    std::set<std::size_t> moved;
    for (const Taken& one : allTaken()) {
        asked.insert(one.source);
        SourcesRig mount;
        const auto answer = mount.sources[one.source]->take(one.request, one.by);
        if (answer && *answer && mount.movesWithin(Seconds(0.5))) {
            moved.insert(one.source);
        }
    }
    const SourcesRig mount;
    for (std::size_t i = 0; i < mount.sources.size(); ++i) {
        EXPECT_EQ(moved.contains(i), asked.contains(i)) << nameOf(*mount.sources[i]);
    }
}

TEST(MotionSources, EachRefusesBehindALatchedStop)
{
    const auto stop = [](StationRig& rig) { return rig.ask(request::Stop{}).has_value(); };
    expectRefusals(stop, kOperator);
    expectRefusals(stop, kClient);
}

TEST(MotionSources, EachRefusesClientsWithoutTheAuthority)
{
    expectRefusals([](StationRig& rig) { return rig.ask(request::TakeAuthority{}).has_value(); }, kClient);
}

TEST(MotionSources, EachRefusesWithDrivesThatAreNotFit)
{
    const auto unfit = [](StationRig& rig) {
        rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("not fit")));
        return true;
    };
    expectRefusals(unfit, kOperator);
    expectRefusals(unfit, kClient);
}

TEST(MotionSources, EachRefusesBehindALatchedFault)
{
    const auto lose = [](StationRig& rig) {
        rig.azimuth.fault = 38;
        rig.azimuth.mode = moteus::Mode::Fault;
        rig.run(Seconds(0.5));
        return rig.state() == StationState::Fault;
    };
    expectRefusals(lose, kOperator);
    expectRefusals(lose, kClient);
}

// REQ-WIND-21
TEST(MotionSources, EachButParkRefusesInAStrongWind)
{
    const auto blow = [](StationRig& rig) {
        profile::Profile windy = rig.profile;
        windy.wind.source = "udp:4541";
        rig.setProfile(windy);
        rig.control.takeWind(30.0);
        rig.tick();
        return !rig.control.windObstacle().isEmpty();
    };
    expectRefusals(blow, kOperator, true);
    expectRefusals(blow, kClient, true);
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
// The station tracks a satellite by its orbital elements, from its rise to its set.
#include "core/alarms/catalogue.h"
#include "core/passes/pass_finder.h"
#include "core/sources/steered_utc.h"
#include "core/sources/target_track.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/found_orbit.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace boresight {
namespace {

using fakes::FoundOrbit;
using fakes::orbitWith;
using testing::HasSubstr;

const Site kTrackSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile atTrackSite()
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kTrackSite.latitude,
                    .longitude = kTrackSite.longitude,
                    .heightMetres = kTrackSite.heightMetres};
    return profile;
}

class StationSatellite : public ::testing::Test
{
protected:
    explicit StationSatellite(const profile::Profile& profile = atTrackSite()) : rig(profile) { rig.run(Seconds(0.5)); }

    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    // A satellite that rises between these two times from the present.
    FoundOrbit risingIn(Seconds from, Seconds to)
    {
        return orbitWith(kTrackSite, now(), [&](const passes::Pass& pass) {
            const Seconds wait = pass.aos.utc - now();
            const Angle highest = pass.tca.direction.elevation;
            return from < wait && wait < to && 40_deg < highest && highest < 60_deg && !pass.isUpAtEnd;
        });
    }
    FoundOrbit follow(Seconds from = Seconds(60.0), Seconds to = Seconds(120.0))
    {
        FoundOrbit found = risingIn(from, to);
        EXPECT_EQ(ask(found), "");
        return found;
    }
    std::string ask(const FoundOrbit& found, const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request::Track{targets::satelliteTarget(found.elements)}, by);
        return answer ? std::string() : textOf(answer.error());
    }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            rig.tick();
        }
    }
    static SkyPointing directionOf(const FoundOrbit& found, UtcTime utc)
    {
        return fakes::directionOf(found, kTrackSite, utc);
    }
    // Error of the set-points from the satellite, in degrees on the sky: azimuth × cos elevation, elevation.
    [[nodiscard]] std::pair<double, double> errors(const FoundOrbit& found) const
    {
        const SkyPointing wanted = directionOf(found, now());
        const SkyPointing is = *rig.control.status().commanded;
        const Angle across = is.azimuth - wanted.azimuth.nearestTo(is.azimuth);
        return {across.degrees() * std::cos(wanted.elevation.radians()), (is.elevation - wanted.elevation).degrees()};
    }
    static void expectWayOf(const FoundOrbit& found, const std::vector<targets::SkyMoment>& way)
    {
        ASSERT_GT(way.size(), 2U);
        EXPECT_LT(std::chrono::abs(way.front().utc - found.pass.aos.utc), std::chrono::milliseconds(100));
        EXPECT_LT(std::chrono::abs(way.back().utc - found.pass.los.utc), std::chrono::milliseconds(100));
        for (std::size_t i = 1; i < way.size(); ++i) {
            EXPECT_LE(way[i].utc - way[i - 1].utc, std::chrono::seconds(5));
            const SkyPointing there = directionOf(found, way[i].utc);
            EXPECT_LT(angleBetween(way[i].direction, {there.azimuth, std::max(there.elevation, 0_deg)}), 0.001_deg);
        }
    }
    [[nodiscard]] QString remedyOf(const char* alarm) const
    {
        const std::vector<Alarm> all = rig.alarms.list();
        const auto found = std::ranges::find(all, QString::fromLatin1(alarm), &Alarm::name);
        return found == all.end() ? QString() : found->remedy;
    }
    [[nodiscard]] bool isTracking() const { return rig.control.status().tracked.has_value(); }
    [[nodiscard]] bool logged(const char* words) const
    {
        return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); });
    }

    StationRig rig;
};

// Tracks whole passes, which last for minutes.
class StationSatellitePass : public StationSatellite
{
protected:
    StationSatellitePass() : StationSatellite(slowly()) {}

    static profile::Profile slowly()
    {
        profile::Profile profile = atTrackSite();
        profile.control.tickHz = 20;  // the lowest
        profile.control.watchdog = Seconds(0.2);
        return profile;
    }
};

// REQ-TRACK-900: Track sends the mount to where the satellite rises, tracks it until it sets, and then holds. The
// window shows what the station waits for or tracks, the path, and when it ends. Nothing moves afterwards.
TEST_F(StationSatellitePass, WaitsWhereItRisesFollowsItUntilItSetsAndHolds)
{
    const FoundOrbit found = follow();
    runUntil(found.pass.aos.utc - std::chrono::seconds(1));
    StationStatus status = rig.control.status();
    ASSERT_TRUE(status.tracked);
    EXPECT_FALSE(status.tracked->isUp);
    EXPECT_EQ(status.tracked->name.toStdString(), "TEST ONE");
    EXPECT_LT(std::chrono::abs(*status.tracked->next - found.pass.aos.utc), std::chrono::milliseconds(100));
    EXPECT_NEAR(status.actual->azimuth.wrapped360().degrees(), found.pass.aos.direction.azimuth.degrees(), 0.05);
    EXPECT_FALSE(rig.moving()) << "it waits there";
    expectWayOf(found, *status.tracked->way);

    runUntil(found.pass.tca.utc);
    status = rig.control.status();
    ASSERT_TRUE(status.tracked);
    EXPECT_TRUE(status.tracked->isUp);
    EXPECT_LT(std::chrono::abs(*status.tracked->next - found.pass.los.utc), std::chrono::milliseconds(100));
    EXPECT_EQ(status.state, StationState::Track);
    EXPECT_EQ(status.targetText.toStdString(), "track TEST ONE");
    const Angle inASecond =
        angleBetween(directionOf(found, now()), directionOf(found, now() + std::chrono::seconds(1)));
    EXPECT_NEAR(status.tracked->skyRate.value().degrees(), inASecond.degrees(), 0.01 * inASecond.degrees());

    runUntil(found.pass.los.utc + std::chrono::seconds(5));
    EXPECT_FALSE(isTracking());
    EXPECT_TRUE(logged("TEST ONE has set, and the mount holds"));
    const AxisPosition before{*rig.control.status().azimuth.actual, *rig.control.status().elevation.actual};
    rig.run(Seconds(60.0));
    EXPECT_NEAR(rig.azimuthDegrees(), before.azimuth.degrees(), 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), before.elevation.degrees(), 0.01);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-TRACK-901: In a pass that culminates between 40° and 60° the set-points are at most 0.02° rms from the satellite
// in each axis, from 5 s after its rise. The azimuth error counts as an angle on the sky.
TEST_F(StationSatellite, TheSetPointsAreWithinTwoHundredthsOfADegree)
{
    const FoundOrbit found = follow();
    runUntil(found.pass.aos.utc + std::chrono::seconds(5));
    double azimuth = 0.0;
    double elevation = 0.0;
    int count = 0;
    while (now() < found.pass.los.utc - std::chrono::seconds(1)) {
        rig.run(Seconds(0.1));  // a whole status costs as much as a tick
        const auto [across, along] = errors(found);
        azimuth += across * across;
        elevation += along * along;
        ++count;
    }
    EXPECT_GT(count, 2'000);
    EXPECT_LT(std::sqrt(azimuth / count), 0.02);
    EXPECT_LT(std::sqrt(elevation / count), 0.02);
}

// REQ-TRACK-902: Track is refused with the reason: no site is set, the elements are older than the profile permits, or
// the satellite does not rise within a day or within half an hour. A client cannot start it.
TEST_F(StationSatellite, IsRefusedWithTheReason)
{
    FoundOrbit later = orbitWith(
        kTrackSite, now(), [&](const passes::Pass& pass) { return pass.aos.utc - now() > std::chrono::minutes(40); });
    EXPECT_THAT(ask(later), HasSubstr("TEST ONE rises at 0"));
    FoundOrbit old = risingIn(Seconds(60.0), Seconds(120.0));
    old.elements.epoch = orbit::julianDate(now() - std::chrono::days(31));
    EXPECT_THAT(ask(old), HasSubstr("are 31.0 days old. The setting oldest_days permits 30."));
    FoundOrbit never = later;
    never.elements.inclination = 1_deg;
    EXPECT_EQ(ask(never), "TEST ONE does not rise within a day.");
    const FoundOrbit soon = risingIn(Seconds(60.0), Seconds(120.0));
    EXPECT_NE(ask(soon, kClient), "");
    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    EXPECT_EQ(ask(soon), "The site of the mount is not set. Enter it in the profile.");
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.moving());
}

// REQ-TRACK-903: STOP, Hold, a jog, another target and handing over control end the tracking. It does not resume by
// itself.
TEST_F(StationSatellitePass, EverythingElseEndsIt)
{
    const std::vector<std::function<void()>> enders{
        [&] { ASSERT_TRUE(rig.ask(request::Stop{})); },
        [&] { ASSERT_TRUE(rig.ask(request::Hold{})); },
        [&] { ASSERT_TRUE(rig.ask(request::GiveAuthority{})); },
        [&] { ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 20_deg}})); },
        [&] { ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}})); },
    };
    for (const auto& end : enders) {
        const FoundOrbit found = follow(Seconds(5.0), Seconds(120.0));
        runUntil(found.pass.aos.utc + std::chrono::seconds(20));
        ASSERT_TRUE(isTracking());
        end();
        rig.run(Seconds(1.0));
        EXPECT_FALSE(isTracking());
        rig.settle();
        (void)rig.ask(request::ResetStop{});
        const double azimuth = rig.azimuthDegrees();
        rig.run(Seconds(10.0));
        EXPECT_NEAR(rig.azimuthDegrees(), azimuth, 0.01);
        EXPECT_FALSE(isTracking());
    }
}

// REQ-TRACK-912: An alarm reports that a target is tracked while no time source sets the clock. It says how far the
// target moves across the sky in a second. The alarm ends with the tracking. A place on the Earth and a fixed direction
// need no clock.
TEST_F(StationSatellite, AClockThatNothingSetsIsAnAlarm)
{
    const FoundOrbit found = follow();
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.alarms.active(alarmEntry("track.clock")));
    rig.clock.setSynchronised(false);
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.alarms.active(alarmEntry("track.clock")));
    const UtcTime middle = found.pass.tca.utc;
    const Angle fastest =
        angleBetween(directionOf(found, middle), directionOf(found, middle + std::chrono::seconds(1)));
    EXPECT_NEAR(remedyOf("track.clock").section(QStringLiteral("up to "), 1).section(QChar(0xb0), 0, 0).toDouble(),
                fastest.degrees(), 0.01)
        << remedyOf("track.clock").toStdString();
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.alarms.active(alarmEntry("track.clock")));
    ASSERT_TRUE(rig.ask(request::Track{{.name = QStringLiteral("IM58kr"), .kind = targets::EarthPosition{}}}));
    rig.run(Seconds(0.2));
    EXPECT_FALSE(rig.alarms.active(alarmEntry("track.clock")));
}

// REQ-TRACK-904: A small correction of the clock is spread over the ticks, at most 1 ms in each tick, so no set-point
// jumps. A clock that is set by more than half a second applies at once, within the limits of the mount.
TEST_F(StationSatellite, ACorrectionOfTheClockLeapsNowhere)
{
    const FoundOrbit found = follow();
    runUntil(found.pass.tca.utc);
    rig.clock.stepUtc(Seconds(0.2));
    SkyPointing before = *rig.control.status().target;
    for (int i = 0; i < 300; ++i) {
        rig.tick();
        const SkyPointing target = *rig.control.status().target;
        EXPECT_LT(abs(target.elevation - before.elevation), 0.05_deg);
        before = target;
    }
    const auto [across, along] = errors(found);
    EXPECT_LT(std::hypot(across, along), 0.02) << "6 s later it is taken up";
    rig.clock.stepUtc(Seconds(-3.0));
    rig.run(Seconds(5.0));
    const auto [acrossNow, alongNow] = errors(found);
    EXPECT_LT(std::hypot(acrossNow, alongNow), 0.02);
}

// REQ-TRACK-905: An orbit that can no longer be computed ends the tracking with an alarm. The mount holds.
TEST_F(StationSatellitePass, AnOrbitThatEndsIsAnAlarm)
{
    FoundOrbit falling = risingIn(Seconds(20.0), Seconds(120.0));
    bool found = false;
    // A drag beyond that of any satellite: the mean eccentricity leaves the range of the theory.
    for (double bstar = 1e-3; bstar < 1e4 && !found; bstar *= 1.2) {
        falling.elements.bstar = bstar;
        const auto list =
            passes::findPasses(orbit::Sgp4(falling.elements),
                               {.site = kTrackSite, .from = now(), .to = now() + std::chrono::hours(1), .isClear = {}});
        found = list.end && !list.passes.empty() && list.passes.front().isUpAtEnd &&
                list.passes.front().aos.utc + std::chrono::seconds(30) < list.end->utc;
        falling.pass = found ? list.passes.front() : falling.pass;
    }
    ASSERT_TRUE(found);
    EXPECT_EQ(ask(falling), "");
    runUntil(falling.pass.los.utc + std::chrono::seconds(3));
    EXPECT_FALSE(isTracking());
    EXPECT_TRUE(rig.alarms.active(alarmEntry("track.no-orbit")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-TRACK-906: Before a pass begins the mount chooses a wrap of the cable that has room for the whole pass, if there
// is one.
TEST_F(StationSatellitePass, TheWrapHasRoomForTheWholePass)
{
    for (const Angle start : {-80_deg, 440_deg}) {
        rig.settle();
        ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = start, .elevation = 30_deg}}));
        rig.settle();
        const FoundOrbit found = follow();
        runUntil(found.pass.aos.utc);
        const std::uint64_t lines = rig.log.lastNumber();
        runUntil(found.pass.los.utc);
        for (const LogEntry& line : rig.log.since(lines, EventLog::kCapacity)) {
            EXPECT_FALSE(line.text.contains(QLatin1String("because the cable ends"))) << start.degrees();
        }
    }
}

// A mount without cable overlap: its cable ends at north.
class StationSatelliteNorth : public StationSatellite
{
protected:
    StationSatelliteNorth() : StationSatellite(withoutOverlap()) {}

    static profile::Profile withoutOverlap()
    {
        profile::Profile profile = atTrackSite();
        profile.control.tickHz = 20;  // the lowest, because the passes last for minutes
        profile.control.watchdog = Seconds(0.2);
        profile.limits.azimuth = {0_deg, 360_deg};
        return profile;
    }
};

// REQ-CONTROL-31c
TEST_F(StationSatelliteNorth, OfAStreamHoldingIsJudgedByItsAzimuthRate)
{
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 330_deg, .elevation = 30_deg}}));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    for (int second = 0; second < 8; ++second) {
        ASSERT_TRUE(rig.point(330.0 + second, 30.0));
        rig.run(Seconds(1.0));
    }
    ASSERT_TRUE(rig.control.status().cableEnd);
    EXPECT_TRUE(rig.control.status().cableEnd->turningBack);
    // Half a turn at 1°/s, then half a turn of the mount at 10°/s.
    ASSERT_TRUE(rig.control.status().cableEnd->lostByHolding);
    EXPECT_EQ(rig.control.status().cableEnd->lostByHolding->count(), 200.0);
}

TEST(SteeredUtc, TakesUpSmallCorrectionsSlowlyAndASetClockAtOnce)
{
    fakes::ManualClock clock;
    sources::SteeredUtc steered;
    EXPECT_EQ(steered.now(clock), clock.utc());
    clock.stepUtc(Seconds(0.010));
    EXPECT_EQ(clock.utc() - steered.now(clock), std::chrono::milliseconds(9));
    for (int i = 0; i < 9; ++i) {
        (void)steered.now(clock);
    }
    EXPECT_EQ(steered.now(clock), clock.utc());
    EXPECT_EQ(steered.jump(), Seconds(0.0));
    clock.stepUtc(Seconds(-2.0));
    EXPECT_EQ(steered.now(clock), clock.utc());
    EXPECT_EQ(steered.jump(), Seconds(-2.0));
    EXPECT_EQ(steered.now(clock), clock.utc());
    EXPECT_EQ(steered.jump(), Seconds(0.0));
}

}  // namespace
}  // namespace boresight

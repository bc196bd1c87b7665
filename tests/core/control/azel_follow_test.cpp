// SPDX-License-Identifier: GPL-3.0-or-later
// The station tracks the Moon with the file azel.dat of WSJT-X.
#include "core/sources/azel_follow.h"

#include "core/alarms/catalogue.h"
#include "core/ephemeris/rise_set.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/azel_writer.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace boresight {
namespace {

using testing::HasSubstr;

const Site kMoonSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr Angle kHalfStep = Angle::fromDegrees(0.0708);  // half a step of the file, in both angles

profile::Profile atMoonSite()
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kMoonSite.latitude,
                    .longitude = kMoonSite.longitude,
                    .heightMetres = kMoonSite.heightMetres};
    profile.park = {.azimuth = 30_deg, .elevation = 20_deg};
    return profile;
}

class StationAzelFollow : public ::testing::Test
{
protected:
    StationAzelFollow()
    {
        moonIs(40_deg);
        rig.run(Seconds(0.2));
    }

    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    // Sets the clock to the next moment when the rising Moon passes this elevation.
    void moonIs(Angle elevation)
    {
        ephemeris::Almanac almanac(kMoonSite);
        const auto rises = ephemeris::nextRise(almanac, ephemeris::Body::Moon, now(), elevation);
        ASSERT_TRUE(rises);
        rig.clock.setUtc(*rises);
    }
    void moonSetsTo(Angle elevation)
    {
        ephemeris::Almanac almanac(kMoonSite);
        const auto sets = ephemeris::nextSet(almanac, ephemeris::Body::Moon, now(), elevation);
        ASSERT_TRUE(sets);
        rig.clock.setUtc(*sets);
    }
    void look() { (void)rig.control.receive(writer.readingAt(rig.clock.computerUtc())); }
    // Runs the station while WSJT-X writes the file every second.
    void run(
        Seconds time, const std::function<void()>& each = [] {})
    {
        for (Seconds left = time; left > Seconds(0.0); left -= rig.step) {
            if (std::chrono::floor<std::chrono::seconds>(now()) != m_written && isWriting) {
                m_written = std::chrono::floor<std::chrono::seconds>(now());
                look();
            }
            rig.tick();
            each();
        }
    }
    std::string ask(const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request::FollowAzel{}, by);
        return answer ? std::string() : textOf(answer.error());
    }
    // Starts to track the Moon and runs until the mount is on the Moon.
    void follow()
    {
        run(Seconds(2.5));
        ASSERT_EQ(ask(), "");
        run(Seconds(20.0));
        ASSERT_LT(off(), 0.02_deg);
    }
    void set(const profile::AzelSettings& settings)
    {
        profile::Profile profile = rig.profile;
        profile.azel = settings;
        rig.setProfile(profile);
    }
    // Angle between the set-points and the Moon of the file.
    [[nodiscard]] Angle off() { return angleBetween({place().azimuth, place().elevation}, writer.moon(now())); }
    // Axis positions of the set-points.
    [[nodiscard]] AxisPosition place() const
    {
        const auto sample = rig.control.sample();
        return {*sample->axes[0].commanded, *sample->axes[1].commanded};
    }
    [[nodiscard]] AzelStatus status() const { return rig.control.status().azel; }
    [[nodiscard]] bool isFollowing() const { return status().phase != AzelPhase::Off; }
    [[nodiscard]] int starts() const
    {
        const auto lines = rig.log.since(0, EventLog::kCapacity);
        return static_cast<int>(
            std::ranges::count_if(lines, [](const LogEntry& line) { return line.kind == LogKind::MotionStart; }));
    }

    StationRig rig{atMoonSite()};
    fakes::AzelWriter writer{kMoonSite};
    bool isWriting = true;

private:
    UtcTime m_written{};
};

// REQ-AZEL-911: The mount tracks the Moon of the file. While the file agrees with the Moon that Boresight computes, the
// computed Moon fills the gaps between the 0.1° steps of the file. The set-points are within 0.01° of the Moon and
// never jump.
TEST_F(StationAzelFollow, OurOwnMoonFillsTheStepsOfTheFile)
{
    follow();
    EXPECT_TRUE(status().interpolates);
    EXPECT_LT(*status().apart, kHalfStep);
    EXPECT_EQ(status().phase, AzelPhase::Following);
    AxisPosition before = place();
    run(Seconds(60.0), [&] {
        EXPECT_LT(off(), 0.01_deg);
        const AxisPosition here = place();
        EXPECT_LT(abs(here.azimuth - before.azimuth), 0.001_deg);
        before = here;
    });
    const StationStatus status = rig.control.status();
    EXPECT_EQ(status.state, StationState::Track);
    EXPECT_EQ(status.targetText.toStdString(), "track the Moon by WSJT-X");
    ASSERT_TRUE(status.tracked);
    EXPECT_TRUE(status.tracked->isUp);
    ASSERT_TRUE(status.tracked->next);
    EXPECT_NEAR(status.tracked->skyRate.value().degrees(), 0.004, 0.0006) << "for the clock";
    EXPECT_GT(*status.tracked->next, now());
}

// REQ-AZEL-912: Where the file and the computed Moon differ by more than 0.2°, or where no site is set, the mount
// follows the steps of the file. An advisory names the difference. If they differ by more than 2° the mount does not go
// there, because the file is for another place.
TEST_F(StationAzelFollow, AFileThatDiffersIsFollowedInItsSteps)
{
    writer.moonInstead = SkyPointing{120.3_deg, 40.1_deg};
    run(Seconds(2.5));
    EXPECT_THAT(ask(), HasSubstr("away from the computed Moon. The locator in WSJT-X or the site is wrong"));
    SkyPointing beside = writer.moon(now());
    beside.elevation += 0.7_deg;
    writer.moonInstead = beside;
    run(Seconds(2.5));
    ASSERT_EQ(ask(), "");
    run(Seconds(60.0));
    EXPECT_TRUE(rig.alarms.active(alarmEntry("azel.differs")));
    EXPECT_FALSE(status().interpolates);
    EXPECT_LT(angleBetween(*rig.control.status().commanded, beside), kHalfStep);
    EXPECT_EQ(rig.control.status().commanded->azimuth, rig.control.status().target->azimuth);

    writer.moonInstead = SkyPointing{120.3_deg, 40.1_deg};
    run(Seconds(3.0));
    EXPECT_FALSE(isFollowing());
    EXPECT_TRUE(rig.alarms.active(alarmEntry("azel.ended")));
    EXPECT_FALSE(rig.alarms.active(alarmEntry("azel.differs")));

    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    ASSERT_EQ(ask(), "");
    EXPECT_FALSE(rig.alarms.active(alarmEntry("azel.ended")));
    run(Seconds(60.0));
    EXPECT_LT(angleBetween(*rig.control.status().commanded, *writer.moonInstead), kHalfStep);
    EXPECT_FALSE(status().apart);
}

// REQ-AZEL-925: The file is judged by the clock of this computer, which WSJT-X reads, and the mount is pointed by the
// time before that clock was set. So the mount neither stops nor jumps when the clock is set.
TEST_F(StationAzelFollow, GoesOnWhenTheClockIsSet)
{
    follow();
    const AxisPosition before = place();
    EXPECT_GT(angleBetween(*rig.control.targetAt(now()), *rig.control.targetAt(now() + std::chrono::hours(1))), 5_deg);
    rig.clock.setAhead(Seconds(3600.0));
    run(Seconds(1.0));
    EXPECT_LT(angleBetween({place().azimuth, place().elevation}, {before.azimuth, before.elevation}), 0.02_deg);
    run(Seconds(150.0));
    EXPECT_EQ(status().phase, AzelPhase::Following);
    EXPECT_EQ(status().problem.toStdString(), "");
    EXPECT_LT(off(), 0.02_deg);
}

// REQ-AZEL-913: Tracking by the file is refused with the reason: there is no file, nobody writes the file, a client
// asks, or the mount may move only while receiving and the file has no transmit flag. The screen shows the same reason.
TEST_F(StationAzelFollow, IsRefusedWithTheReason)
{
    rig.run(Seconds(1.0));
    EXPECT_EQ(ask(), "azel.dat cannot be used: the file was not read yet");
    look();
    rig.run(Seconds(1.0));
    EXPECT_THAT(ask(), HasSubstr("nothing writes the file"));
    EXPECT_THAT(rig.control.status().permissions.reason(Action::FollowAzel).toStdString(),
                HasSubstr("nothing writes the file"));
    set({.onlyWhileReceiving = profile::OnlyWhileReceiving::On});
    writer.flag = "";
    run(Seconds(2.0));
    EXPECT_THAT(ask(), HasSubstr("it does not show whether the radio transmits"));
    writer.flag = ", R";
    run(Seconds(2.0));
    EXPECT_NE(ask(kClient), "");
    EXPECT_FALSE(rig.moving());
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::FollowAzel));
    EXPECT_EQ(ask(), "");
}

// REQ-AZEL-914: The mount moves at the interval of the profile, or when the Moon is farther away than the set part of
// the beam width. It stands still in between.
TEST_F(StationAzelFollow, MovesByTheIntervalOrThePartOfTheBeam)
{
    follow();
    const auto movesWithin = [&](Seconds time) {
        int moves = 0;
        bool wasMoving = false;
        AxisPosition before = place();
        run(time, [&] {
            const bool isMoving = place() != before;
            before = place();
            moves += isMoving && !wasMoving ? 1 : 0;
            wasMoving = isMoving;
            EXPECT_LT(off(), 0.11_deg);
        });
        return moves;
    };
    set({.interval = Seconds(10.0)});
    run(Seconds(3.0));
    EXPECT_EQ(movesWithin(Seconds(40.0)), 4);

    profile::Profile narrow = rig.profile;
    narrow.mount.beamWidth = 0.5_deg;
    narrow.azel = {.beamFraction = 0.2};
    rig.setProfile(narrow);
    run(Seconds(3.0));
    const int moves = movesWithin(Seconds(80.0));  // the Moon moves by 0.32°
    EXPECT_GE(moves, 2);
    EXPECT_LE(moves, 3);
}

// REQ-AZEL-915: If the profile says so, nothing moves while the radio transmits, not even on the way to the Moon. The
// mount makes the postponed motion when the radio receives.
TEST_F(StationAzelFollow, MovesOnlyWhileReceiving)
{
    set({.onlyWhileReceiving = profile::OnlyWhileReceiving::On});
    run(Seconds(2.5));
    ASSERT_EQ(ask(), "");
    run(Seconds(2.0));
    ASSERT_TRUE(rig.moving()) << "on its way";
    writer.flag = ", T";
    run(Seconds(6.0));
    EXPECT_FALSE(rig.moving());
    EXPECT_EQ(status().phase, AzelPhase::Transmitting);
    const AxisPosition stopped = place();
    run(Seconds(50.0));
    EXPECT_EQ(place(), stopped);
    writer.flag = ", R";
    run(Seconds(60.0));
    EXPECT_LT(off(), 0.01_deg);

    writer.flag = ", T";
    run(Seconds(3.0));
    const AxisPosition held = place();
    run(Seconds(57.0));
    EXPECT_LT(abs(place().azimuth - held.azimuth), 1e-6_deg);
    EXPECT_GT(off(), 0.15_deg);
    writer.flag = ", R";
    const int before = starts();
    run(Seconds(5.0));
    EXPECT_LT(off(), 0.01_deg);
    EXPECT_EQ(starts(), before) << "it is one motion";
}

// REQ-AZEL-922: The Moon moves on while the mount stands still for the radio. The status shows the Moon as the target,
// and the error is measured from the Moon.
TEST_F(StationAzelFollow, TheMoonIsTheTargetWhileTheMountStandsStill)
{
    set({.onlyWhileReceiving = profile::OnlyWhileReceiving::On});
    writer.flag = ", T";
    run(Seconds(2.5));
    ASSERT_EQ(ask(), "");
    run(Seconds(2.0));
    const StationStatus status = rig.control.status();
    const SkyPointing moon = writer.moon(now());
    ASSERT_TRUE(status.target);
    EXPECT_LT(angleBetween(*status.target, moon), 0.1_deg);
    EXPECT_LT(angleBetween({*status.azimuth.beam.target, *status.elevation.beam.target}, moon), 0.1_deg);
    EXPECT_GT(off(), 10_deg);
    EXPECT_EQ(status.state, StationState::Hold);
    EXPECT_EQ(status.stateReason, QStringLiteral("stands still while WSJT-X transmits"));
}

// REQ-AZEL-916: Below the horizon the mount is parked once, and the status shows the time of the next rise. The mount
// tracks the Moon again from its rise. At the horizon the mount does not go back and forth.
TEST_F(StationAzelFollow, IsParkedOnceWhileTheMoonIsDown)
{
    moonSetsTo(0.2_deg);
    follow();
    const int before = starts();
    run(Seconds(160.0));
    StationStatus status = rig.control.status();
    EXPECT_EQ(status.azel.phase, AzelPhase::BelowHorizon);
    EXPECT_EQ(status.state, StationState::Parked);
    EXPECT_EQ(starts(), before + 1);
    ASSERT_TRUE(status.tracked);
    EXPECT_FALSE(status.tracked->isUp);
    ASSERT_TRUE(status.tracked->next);
    EXPECT_GT(*status.tracked->next, now() + std::chrono::hours(8));

    rig.clock.stepUtc(*status.tracked->next - now() - std::chrono::seconds(20));
    run(Seconds(15.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    run(Seconds(30.0));
    EXPECT_EQ(this->status().phase, AzelPhase::Following);
    EXPECT_LT(off(), 0.01_deg);
    EXPECT_EQ(starts(), before + 2);
}

// The operator's trim is part of the position that the mount holds.
TEST_F(StationAzelFollow, ATrimIsHeldWhileTheRadioTransmits)
{
    set({.onlyWhileReceiving = profile::OnlyWhileReceiving::On});
    follow();
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 3_deg, .elevation = -1_deg}));
    run(Seconds(5.0));
    ASSERT_TRUE(isFollowing());
    EXPECT_GT(off(), 2_deg);
    writer.flag = ", T";
    run(Seconds(2.0));
    const AxisPosition held = place();
    run(Seconds(10.0));
    EXPECT_LT(abs(place().azimuth - held.azimuth), 1e-6_deg);
    EXPECT_GT(off(), 2_deg);
}

TEST_F(StationAzelFollow, ParkingWaitsForReceiving)
{
    set({.onlyWhileReceiving = profile::OnlyWhileReceiving::On});
    moonSetsTo(-5_deg);
    writer.flag = ", T";
    run(Seconds(2.5));
    ASSERT_EQ(ask(), "");
    run(Seconds(10.0));
    EXPECT_FALSE(rig.moving());
    writer.flag = ", R";
    run(Seconds(60.0));
    EXPECT_EQ(rig.state(), StationState::Parked);
    const int before = starts();
    for (const char* const flag : {", T", ", R", ", T", ", R"}) {
        writer.flag = flag;
        run(Seconds(5.0));
        EXPECT_EQ(rig.state(), StationState::Parked);
    }
    EXPECT_EQ(starts(), before) << "once";
}

// REQ-AZEL-917: The mount stands still 30 s after the last change of the file, with an alarm. Tracking continues if the
// file is written again within 2 minutes. After that the tracking has ended, with an alarm, and does not resume by
// itself.
TEST_F(StationAzelFollow, AStaleFileHoldsAndThenEndsIt)
{
    follow();
    isWriting = false;
    run(Seconds(28.0), [&] { EXPECT_LT(off(), 0.01_deg); });
    run(Seconds(4.0));
    EXPECT_EQ(status().phase, AzelPhase::Stale);
    EXPECT_TRUE(rig.alarms.active(alarmEntry("azel.stale")));
    const AxisPosition held = place();
    run(Seconds(100.0));
    EXPECT_EQ(place(), held);
    isWriting = true;
    run(Seconds(20.0));
    EXPECT_EQ(status().phase, AzelPhase::Following);
    EXPECT_FALSE(rig.alarms.active(alarmEntry("azel.stale")));
    EXPECT_LT(off(), 0.01_deg);

    isWriting = false;
    run(Seconds(153.0));
    EXPECT_FALSE(isFollowing());
    EXPECT_TRUE(rig.alarms.active(alarmEntry("azel.ended")));
    EXPECT_EQ(rig.state(), StationState::Hold);
    isWriting = true;
    const AxisPosition ended = place();
    run(Seconds(30.0));
    EXPECT_EQ(place(), ended);
}

// REQ-AZEL-918: STOP, Hold, a jog, another target, the operator's own Park and handing over control end the tracking.
// It does not resume by itself, and it does not disturb another target.
TEST_F(StationAzelFollow, EverythingElseEndsIt)
{
    const std::vector<std::function<void()>> enders{
        [&] { ASSERT_TRUE(rig.ask(request::Stop{})); },
        [&] { ASSERT_TRUE(rig.ask(request::Hold{})); },
        [&] { ASSERT_TRUE(rig.ask(request::GiveAuthority{})); },
        [&] { ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 10_deg, .elevation = 20_deg}})); },
        [&] { ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}})); },
        [&] { ASSERT_TRUE(rig.ask(request::Park{})); },
        [&] {
            ASSERT_TRUE(rig.ask(request::Follow{.direction = {10_deg, 30_deg}, .what = QStringLiteral("Sun")}));
        },
    };
    for (const auto& end : enders) {
        follow();
        end();
        run(Seconds(1.0));
        EXPECT_FALSE(isFollowing());
        run(Seconds(15.0));
        (void)rig.ask(request::ResetStop{});
        const AxisPosition there = place();
        run(Seconds(10.0));
        EXPECT_EQ(place(), there);
        EXPECT_FALSE(isFollowing());
    }
    EXPECT_NEAR(place().azimuth.degrees(), 10.0, 0.01) << "the last one was not held on its way";
}

// REQ-AZEL-921: Where possible the mount chooses a wrap of the cable that has room until the Moon sets. This needs a
// computed Moon that agrees with the file. The same choice is made after each rise.
TEST_F(StationAzelFollow, TheWrapHasRoomUntilTheMoonSets)
{
    moonIs(5_deg);
    const Angle moon = writer.moon(now()).azimuth;
    ASSERT_LT(moon + 360_deg, rig.profile.limits.azimuth.max) << "the nearest wrap is within the travel";
    run(Seconds(2.5));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = moon + 350_deg, .elevation = 30_deg}}));
    run(Seconds(60.0));
    ASSERT_NEAR(place().azimuth.degrees(), (moon + 350_deg).degrees(), 0.1);
    ASSERT_EQ(ask(), "");
    run(Seconds(60.0));
    EXPECT_EQ(status().phase, AzelPhase::Following);
    EXPECT_NEAR(place().azimuth.degrees(), moon.degrees(), 2.0) << "the nearest wrap ends before the Moon sets";
}

}  // namespace
}  // namespace boresight

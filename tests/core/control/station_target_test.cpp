// SPDX-License-Identifier: GPL-3.0-or-later
// Targets other than satellites that the station tracks by itself: Sun, Moon, planets, radio sources and fixed targets.
#include "core/sources/target_track.h"
#include "core/tables/table_reader.h"
#include "core/targets/target_path.h"
#include "core/targets/target_text.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace boresight {
namespace {

using testing::HasSubstr;

constexpr Site kSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile atSite()
{
    profile::Profile profile;
    profile.site = {
        .known = true, .latitude = kSite.latitude, .longitude = kSite.longitude, .heightMetres = kSite.heightMetres};
    profile.control.tickHz = 20;  // the lowest, because the bodies are tracked for minutes
    profile.control.watchdog = Seconds(0.2);
    return profile;
}

targets::Target targetOf(std::string_view text)
{
    return targets::parseTarget(text, {}).value();
}

// The way of a table of rows, 12° in three minutes from two minutes on.
targets::Target tableFrom(UtcTime start)
{
    std::string text;
    for (int i = 0; i <= 3; ++i) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(start.time_since_epoch()).count();
        text +=
            std::to_string(seconds + 120 + 60 * i) + ' ' + std::to_string(358 + 4 * i - (i > 0 ? 360 : 0)) + " 20\n";
    }
    return targets::tableTarget(tables::readTable(text, QStringLiteral("/tmp/way.txt")).value());
}

class StationTarget : public ::testing::Test
{
protected:
    StationTarget() { rig.run(Seconds(0.5)); }

    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    static targets::TargetPath pathOf(std::string_view text) { return {targetOf(text), kSite}; }
    // Empty if accepted, else the reason.
    std::string ask(std::string_view text, const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request::Track{targetOf(text)}, by);
        return answer ? std::string() : textOf(answer.error());
    }
    void goTo(UtcTime utc)
    {
        rig.clock.setUtc(utc);
        rig.run(Seconds(0.2));
    }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            rig.tick();
        }
    }
    [[nodiscard]] Angle distance(targets::TargetPath path) const
    {
        return angleBetween(*rig.control.status().commanded, path.at(now()).value());
    }
    [[nodiscard]] std::optional<TrackedTarget> tracked() const { return rig.control.status().tracked; }
    [[nodiscard]] bool logged(const QString& words) const
    {
        return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(words); });
    }

    StationRig rig{atSite()};
};

// REQ-TRACK-920: Sun, Moon, planets and radio sources are tracked until they set, within 0.01°. Then the mount holds.
TEST_F(StationTarget, FollowsABodyUntilItSets)
{
    for (const char* const text : {"moon", "sun", "jupiter", "tau a"}) {
        const auto up = pathOf(text).nextUp(now()).value();
        goTo(*up.sets - std::chrono::seconds(180));
        ASSERT_EQ(ask(text), "") << text;
        runUntil(*up.sets - std::chrono::seconds(90));
        const StationStatus status = rig.control.status();
        ASSERT_TRUE(status.tracked) << text;
        EXPECT_EQ(status.tracked->name, targetOf(text).name);
        EXPECT_TRUE(status.tracked->isUp);
        EXPECT_LT(std::chrono::abs(*status.tracked->next - *up.sets), std::chrono::seconds(2));
        EXPECT_EQ(status.state, StationState::Track) << text;
        EXPECT_LT(distance(pathOf(text)), 0.01_deg) << text;
        runUntil(*up.sets + std::chrono::seconds(10));
        EXPECT_FALSE(tracked());
        EXPECT_TRUE(logged(targetOf(text).name + QStringLiteral(" has set, and the mount holds")));
        rig.settle();
        EXPECT_EQ(rig.state(), StationState::Hold);
    }
}

// REQ-CONTROL-31c
TEST(StationTargetSouth, TheWayTellsWhatHoldingAtTheCableEndLoses)
{
    profile::Profile profile = atSite();
    profile.azimuth.geometry.travel = {-180_deg, 180_deg};
    StationRig rig(profile);
    rig.run(Seconds(0.5));
    targets::TargetPath path(targetOf("moon"), kSite);
    const UtcTime sets = path.nextUp(rig.clock.utc()).value().sets.value();
    const auto up = path.nextUp(sets + std::chrono::minutes(1)).value();
    UtcTime south = up.rises;
    while (path.at(south)->azimuth < 180_deg) {
        south += std::chrono::seconds(10);
    }
    rig.clock.setUtc(south - std::chrono::minutes(10));
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.ask(request::Track{targetOf("moon")}));
    rig.settle();
    rig.run(Seconds(5.0));
    ASSERT_TRUE(rig.control.status().cableEnd);
    const CableEnd end = *rig.control.status().cableEnd;
    EXPECT_TRUE(end.turningBack);
    ASSERT_TRUE(end.lostByHolding);
    EXPECT_NEAR(end.lostByHolding->count(), Seconds(*up.sets - south).count(), 400.0) << "the way has a point in 5 min";
    ASSERT_TRUE(rig.ask(request::HoldAtEnd{}));
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.control.status().cableEnd->lostByHolding) << "it is chosen";
}

// REQ-TRACK-928: The direction of the tracked target is known for any time, also below the horizon. For a target that
// does not depend on the time there is none.
TEST_F(StationTarget, TheDirectionAtAnotherTimeIsKnown)
{
    EXPECT_FALSE(rig.control.targetAt(now()));
    goTo(*pathOf("moon").nextUp(now()).value().sets - std::chrono::minutes(10));
    ASSERT_EQ(ask("moon"), "");
    for (const auto later : {std::chrono::minutes(0), std::chrono::minutes(-90), std::chrono::minutes(90)}) {
        const auto direction = rig.control.targetAt(now() + later);
        ASSERT_TRUE(direction);
        EXPECT_LT(angleBetween(*direction, pathOf("moon").at(now() + later).value()), 0.001_deg);
    }
    EXPECT_LT(rig.control.targetAt(now() + std::chrono::minutes(90))->elevation, Angle{});
    ASSERT_EQ(ask("azel 100,30"), "");
    EXPECT_FALSE(rig.control.targetAt(now()));
}

// Story: after a step back by an hour, the mount waited for an hour where the tracking had begun.
// REQ-TRACK-929: After the clock was set, rise and set of the tracked target are searched again. If it would rise in
// more than half an hour, the tracking ends with the reason.
TEST_F(StationTarget, AClockThatIsSetMeansAnotherPass)
{
    ASSERT_EQ(ask("cas a"), "");
    rig.run(Seconds(30.0));
    for (const auto step : {std::chrono::hours(-1), std::chrono::hours(3)}) {
        rig.clock.stepUtc(step);
        rig.run(Seconds(60.0));
        ASSERT_TRUE(tracked());
        EXPECT_EQ(rig.state(), StationState::Track);
        EXPECT_LT(distance(pathOf("cas a")), 0.01_deg);
        EXPECT_LE(tracked()->way->front().utc, now());
    }
    goTo(*pathOf("moon").nextUp(now()).value().sets - std::chrono::minutes(10));
    ASSERT_EQ(ask("moon"), "");
    rig.clock.stepUtc(std::chrono::hours(1));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(tracked());
    EXPECT_TRUE(logged(QStringLiteral("ends the tracking, because the clock was set: Moon rises at")));
}

// REQ-TRACK-921: A body below the horizon is refused with the time of its next rise, or because it does not rise within
// a day. In the last half hour before the rise the mount waits where the body rises, and tracks it from there.
TEST_F(StationTarget, WaitsForABodyToRise)
{
    const auto set = pathOf("sun").nextUp(now() + std::chrono::hours(12)).value().sets.value();
    const auto up = pathOf("sun").nextUp(set + std::chrono::minutes(1)).value();
    goTo(up.rises - std::chrono::minutes(40));
    EXPECT_THAT(ask("sun"), HasSubstr("Sun rises at 07:2"));
    EXPECT_THAT(ask("sun"), HasSubstr("Track it in the last 30 minutes before that."));
    EXPECT_EQ(ask("radec 3,-80"), "RA 3.0000 h, declination -80.000° does not rise within a day.");
    EXPECT_FALSE(tracked());

    goTo(up.rises - std::chrono::minutes(3));
    ASSERT_EQ(ask("sun"), "");
    runUntil(up.rises - std::chrono::seconds(1));
    ASSERT_TRUE(tracked());
    EXPECT_FALSE(tracked()->isUp);
    EXPECT_LT(std::chrono::abs(*tracked()->next - up.rises), std::chrono::seconds(2));
    EXPECT_FALSE(rig.moving());
    EXPECT_LT(distance(pathOf("sun")), 0.02_deg);
    runUntil(up.rises + std::chrono::minutes(2));
    EXPECT_TRUE(tracked()->isUp);
    EXPECT_LT(distance(pathOf("sun")), 0.01_deg);
}

// REQ-TRACK-922: For a direction or a place on the Earth the mount goes there and stays, without an end. A target that
// is out of reach is refused with the reason. A direction needs no site. Each new target is a line in the log.
TEST_F(StationTarget, StaysWhereATargetStays)
{
    for (const char* const text : {"azel 100,30", "IM67", "IM67 long", "place 39.3,-8.5,11000"}) {
        ASSERT_EQ(ask(text), "") << text;
        rig.settle();
        rig.run(Seconds(60.0));
        ASSERT_TRUE(tracked()) << text;
        EXPECT_TRUE(tracked()->isUp);
        EXPECT_FALSE(tracked()->next);
        EXPECT_FALSE(rig.moving());
        EXPECT_LT(distance(pathOf(text)), 0.001_deg) << text;
    }
    EXPECT_TRUE(logged(QStringLiteral("track 100.00° 30.00°")));
    EXPECT_TRUE(logged(QStringLiteral("tracks IM67, long path from now on")));
    EXPECT_THAT(ask("azel 100,-20"), HasSubstr("-20"));
    EXPECT_EQ(ask("place 38.757,-9.117,80"),
              "38.757° north, -9.117° east is the site of the mount, so it has no direction.");
    ASSERT_TRUE(tracked()) << "a refusal changes nothing";

    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    EXPECT_EQ(ask("moon"), "The site of the mount is not set. Enter it in the profile.");
    EXPECT_EQ(ask("azel 100,30"), "");
}

// REQ-TRACK-923: Tracking the Sun is refused while the profile keeps the beam away from it. If keep-away is switched on
// during tracking, the tracking ends and the mount holds.
TEST_F(StationTarget, TheProfileMayForbidTheSun)
{
    goTo(now() + std::chrono::hours(12));
    profile::Profile away = rig.profile;
    away.sun = {.keepAway = profile::KeepAway::On, .radius = 10_deg};
    const profile::Profile free = rig.profile;
    rig.setProfile(away);
    rig.run(Seconds(0.2));
    EXPECT_THAT(ask("sun"), HasSubstr("the profile keeps the beam away from the Sun"));
    EXPECT_EQ(ask("sun"), rig.control.status().permissions.reason(Action::TrackSun).toStdString());
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::Track));
    rig.setProfile(free);
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.control.status().permissions.allows(Action::TrackSun));
    ASSERT_EQ(ask("sun"), "");
    rig.settle();
    rig.setProfile(away);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(tracked());
    EXPECT_TRUE(logged(QStringLiteral("ends the tracking: the profile keeps the beam away from the Sun")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-TRACK-914: The status has the speed of the tracked target across the sky, so that an error of the clock has a
// meaning in degrees. This holds for Sun, Moon, a radio source, a table and a satellite. A fixed target needs no clock.
TEST_F(StationTarget, SaysHowFastItGoesAcrossTheSky)
{
    for (const char* const text : {"moon", "sun", "tau a"}) {
        targets::TargetPath path = pathOf(text);
        goTo(*path.nextUp(now()).value().sets - std::chrono::hours(1));
        ASSERT_EQ(ask(text), "") << text;
        rig.run(Seconds(0.2));
        ASSERT_TRUE(tracked() && tracked()->skyRate) << text;
        const Angle inASecond = angleBetween(path.at(now()).value(), path.at(now() + std::chrono::seconds(1)).value());
        EXPECT_NEAR(tracked()->skyRate->degrees(), inASecond.degrees(), 0.01 * inASecond.degrees()) << text;
        EXPECT_NEAR(inASecond.degrees(), 0.004, 0.0006) << text;
    }
    ASSERT_TRUE(rig.ask(request::Track{tableFrom(std::chrono::floor<std::chrono::seconds>(now()))}));
    rig.run(Seconds(0.2));
    ASSERT_TRUE(tracked()->skyRate);
    EXPECT_NEAR(tracked()->skyRate->degrees(), 4.0 / 60.0 * std::cos((20_deg).radians()), 0.001) << "waits for it";
    for (const char* const text : {"azel 100,30", "IM67"}) {
        ASSERT_EQ(ask(text), "") << text;
        EXPECT_FALSE(tracked()->skyRate) << text;
    }
}

// REQ-TRACK-924: Changing the site during tracking ends the tracking, and the mount holds.
TEST_F(StationTarget, AnotherSiteEndsIt)
{
    goTo(now() + std::chrono::hours(12));
    ASSERT_EQ(ask("sun"), "");
    rig.settle();
    profile::Profile moved = rig.profile;
    moved.site.latitude = 39_deg;
    rig.setProfile(moved);
    rig.run(Seconds(0.2));
    EXPECT_FALSE(tracked());
    EXPECT_TRUE(
        logged(QStringLiteral("ends the tracking: The site of the mount was changed. Track the target again.")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-TRACK-930: The mount tracks a target with the refraction rule of the profile. Another rule applies from the next
// set-point on, and to the path that is shown.
TEST_F(StationTarget, FollowsByTheRuleForRefraction)
{
    const auto up = pathOf("moon").nextUp(now()).value();
    goTo(*up.sets - std::chrono::seconds(600));
    ASSERT_EQ(ask("moon"), "");
    rig.settle();
    targets::TargetPath path = pathOf("moon");
    EXPECT_LT(distance(path), 0.01_deg);
    const targets::SkyWay before = tracked()->way;

    profile::Profile airless = rig.profile;
    airless.orbit.refraction = ephemeris::RefractionRule::None;
    rig.setProfile(airless);
    rig.settle();
    EXPECT_GT(distance(path), 0.2_deg);
    path.setRule(ephemeris::RefractionRule::None);
    EXPECT_LT(distance(path), 0.01_deg);
    ASSERT_TRUE(tracked());
    ASSERT_NE(tracked()->way, before);
    const targets::SkyMoment& shown = tracked()->way->front();
    EXPECT_EQ(shown.direction, path.at(shown.utc).value());
}

// REQ-TRACK-925: A client cannot start tracking of a target, and STOP ends the tracking.
TEST_F(StationTarget, BelongsToTheOperatorAndEndsWithStop)
{
    EXPECT_NE(ask("azel 100,30", kClient), "");
    EXPECT_FALSE(tracked());
    ASSERT_EQ(ask("azel 100,30"), "");
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(tracked());
    EXPECT_NE(ask("azel 100,30"), "") << "STOP is latched";
}

// REQ-TRACK-926: A table from a file is tracked like a satellite. The mount waits where the table begins, follows the
// great circle between its rows within 0.01°, and holds where it ends. A table of directions needs no site.
TEST_F(StationTarget, FollowsATable)
{
    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    const UtcTime start = std::chrono::floor<std::chrono::seconds>(now());
    const targets::Target target = tableFrom(start);
    targets::TargetPath path(target, kSite);
    ASSERT_TRUE(rig.ask(request::Track{target}));
    runUntil(start + std::chrono::seconds(110));
    ASSERT_TRUE(tracked());
    EXPECT_EQ(tracked()->name, QStringLiteral("way.txt"));
    EXPECT_FALSE(tracked()->isUp);
    EXPECT_FALSE(rig.moving());
    EXPECT_LT(angleBetween(*rig.control.status().commanded, {358_deg, 20_deg}), 0.001_deg);
    for (const int seconds : {150, 195, 299}) {
        runUntil(start + std::chrono::seconds(seconds));
        ASSERT_TRUE(tracked()) << seconds;
        EXPECT_TRUE(tracked()->isUp);
        EXPECT_LT(distance(path), 0.01_deg) << seconds;
    }
    runUntil(start + std::chrono::seconds(302));
    EXPECT_FALSE(tracked());
    EXPECT_TRUE(logged(QStringLiteral("the table of way.txt has ended, and the mount holds")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_LT(angleBetween(*rig.control.status().commanded, {10_deg, 20_deg}), 0.1_deg);
    const Result<> over = rig.ask(request::Track{target});
    ASSERT_FALSE(over);
    EXPECT_THAT(textOf(over.error()), HasSubstr("The table of way.txt ended at"));
}

// REQ-TRACK-927: An OEM needs the site. A table that begins in more than half an hour is refused with its start time.
TEST_F(StationTarget, ATableMustLeadSomewhereSoon)
{
    const UtcTime start = std::chrono::floor<std::chrono::seconds>(now());
    const Result<> later = rig.ask(request::Track{tableFrom(start + std::chrono::hours(1))});
    ASSERT_FALSE(later);
    EXPECT_THAT(textOf(later.error()), HasSubstr("way.txt rises at"));
    EXPECT_THAT(textOf(later.error()), HasSubstr("Track it in the last 30 minutes before that."));

    tables::OrbitSegment segment{
        .rows = {{.time = tables::atomicTime(start), .position = {7000.0, 0.0, 0.0}},
                 {.time = tables::atomicTime(start) + std::chrono::minutes(1), .position = {7000.0, 10.0, 0.0}}}};
    segment.from = segment.rows.front().time;
    segment.to = segment.rows.back().time;
    const tables::TableSpan span{.from = segment.from, .to = segment.to};
    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    const Result<> oem = rig.ask(request::Track{targets::tableTarget(std::make_shared<const tables::Table>(
        tables::Table{.name = QStringLiteral("ONE"), .rows = tables::OrbitSegments{segment}, .spans = {span}}))});
    ASSERT_FALSE(oem);
    EXPECT_EQ(textOf(oem.error()), "The site of the mount is not set. Enter it in the profile.");
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rehearsal/rehearsal.h"

#include "tests/fakes/low_orbit.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int kFirst = 90'001;

// Two satellites that pass over the site several times a day.
RehearsalTask nightOfTwo()
{
    const UtcTime now = fakes::ManualClock().utc();
    std::vector<orbit::ElementSet> sets{fakes::lowOrbit(now), fakes::lowOrbit(now, 120_deg, 90_deg)};
    RehearsalTask task{.profile = {}, .satellites = {}, .standing = {}, .from = now};
    task.profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    for (int number = kFirst; orbit::ElementSet & set : sets) {
        set.number = number;
        set.name = "SAT " + std::to_string(number);
        task.profile.schedule.watch.push_back({.number = number++, .leastElevation = 30_deg});
    }
    task.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    return task;
}

Result<RehearsedNight> rehearsed(const RehearsalTask& task)
{
    return rehearse(task, {}, [](double) {});
}

std::string whyNot(const RehearsalTask& task)
{
    const Result<RehearsedNight> night = rehearsed(task);
    return night ? std::string() : textOf(night.error());
}

// REQ-SCHEDULE-940: A rehearsal runs the next day of the schedule in advance, on a copy of the mount and from its
// present position. It gives the plan, the expected report, and the part of the cable that is used. It runs more than
// 60 times faster than real time.
TEST(Rehearsal, TracksEachPassOfThePlan)
{
    RehearsalTask task = nightOfTwo();
    task.standing = {.azimuth = 300_deg, .elevation = 10_deg};
    double done = 0.0;
    const Result<RehearsedNight> night = rehearse(task, {}, [&](double part) {
        EXPECT_GE(part, done);
        done = part;
    });
    ASSERT_TRUE(night);
    EXPECT_LE(done, 1.0);
    EXPECT_GT(done, 0.9);
    EXPECT_EQ(night->from, task.from);
    ASSERT_GE(night->plan.chosen.size(), 2U);
    ASSERT_THAT(night->report.passes, SizeIs(night->plan.chosen.size()));
    EXPECT_EQ(night->report.done(), static_cast<int>(night->plan.chosen.size()));
    for (std::size_t i = 0; i < night->plan.chosen.size(); ++i) {
        const schedule::WatchedPass& planned = night->plan.chosen[i];
        const schedule::PassRecord& record = night->report.passes[i];
        EXPECT_EQ(record.number, planned.number);
        EXPECT_NEAR(record.tracked.count(), Seconds(planned.ends() - planned.begins()).count(), 1.0);
        EXPECT_GT(record.within3dB, 0.9 * record.tracked);
    }
    EXPECT_EQ(night->disarmed, QString());
    EXPECT_GE(night->mostAzimuth, task.standing.azimuth);
    EXPECT_GE(night->leastAzimuth, task.profile.azimuth.geometry.travel.min);
    EXPECT_LE(night->mostAzimuth, task.profile.azimuth.geometry.travel.max);
}

// REQ-SCHEDULE-944: The rehearsal also tracks the rests of passes that are left out. Its report has each pass and each
// rest of the plan, with the seconds.
TEST(Rehearsal, HasTheRestsOfPassesThatAreLeftOut)
{
    RehearsalTask task = nightOfTwo();
    std::vector<orbit::ElementSet> sets = *task.satellites;
    for (int i = 0; i < 3; ++i) {
        orbit::ElementSet beside = fakes::lowOrbit(task.from, {}, Angle::fromDegrees(-8.0 * (i + 1)));
        beside.number = kFirst + 2 + i;
        beside.name = "SAT " + std::to_string(beside.number);
        task.profile.schedule.watch.push_back({.number = kFirst + 2 + i, .priority = 2, .leastElevation = 10_deg});
        sets.push_back(beside);
    }
    task.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    const Result<RehearsedNight> night = rehearsed(task);
    ASSERT_TRUE(night);
    ASSERT_THAT(night->report.passes, SizeIs(night->plan.chosen.size()));
    int rests = 0;
    for (std::size_t i = 0; i < night->plan.chosen.size(); ++i) {
        const schedule::WatchedPass& planned = night->plan.chosen[i];
        const schedule::PassRecord& record = night->report.passes[i];
        const Seconds lasts = planned.ends() - planned.begins();
        EXPECT_EQ(record.number, planned.number);
        EXPECT_LT(std::chrono::abs(record.aos - planned.rises()), std::chrono::milliseconds(10)) << "searched again";
        EXPECT_NEAR(record.tracked.count(), lasts.count(), 1.0);
        EXPECT_GT(record.within3dB, lasts - task.profile.schedule.lead);
        rests += planned.rest ? 1 : 0;
    }
    EXPECT_GT(rests, 0);
}

// REQ-SCHEDULE-941: If the mount is too slow for a pass, the rehearsal shows the seconds beyond 3 dB.
TEST(Rehearsal, ShowsWhatASlowMountLoses)
{
    RehearsalTask task = nightOfTwo();
    task.profile.azimuth.limits.speed = AngularRate::fromDegrees(0.3);
    const Result<RehearsedNight> night = rehearsed(task);
    ASSERT_TRUE(night);
    EXPECT_TRUE(std::ranges::any_of(
        night->report.passes, [](const schedule::PassRecord& pass) { return pass.within3dB < 0.8 * pass.tracked; }));
}

// Story: the first rehearsal showed a line for each 0.1° of the way through the keep-out of the Sun, and nothing else.
// REQ-SCHEDULE-942: The rehearsal has each warning that the station would log, with its time.
// REQ-TRACK-913: A target that crosses a keep-out holds the mount and causes one line in the log.
TEST(Rehearsal, HasTheWarningsOfTheStation)
{
    RehearsalTask task = nightOfTwo();
    task.from += std::chrono::hours(10);
    task.profile.sun = {.keepAway = profile::KeepAway::On, .radius = 60_deg};
    for (schedule::WatchEntry& entry : task.profile.schedule.watch) {
        entry.leastElevation = 5_deg;
    }
    const Result<RehearsedNight> night = rehearsed(task);
    ASSERT_TRUE(night);
    ASSERT_THAT(night->remarks, testing::Not(IsEmpty()));
    EXPECT_THAT(night->remarks.front().text.toStdString(), HasSubstr("Sun"));
    EXPECT_GE(night->remarks.front().utc, night->plan.chosen.front().begins());
    EXPECT_LT(night->remarks.size(), 10 * night->plan.chosen.size());
}

// REQ-SCHEDULE-943: A schedule that cannot be armed is not rehearsed, with the same reason as for arming. A rehearsal
// can be stopped.
TEST(Rehearsal, SaysWhyItCannotBe)
{
    RehearsalTask task = nightOfTwo();
    task.profile.schedule.watch.clear();
    EXPECT_EQ(whyNot(task), "The watch list of the profile is empty.");
    task = nightOfTwo();
    task.profile.site.known = false;
    EXPECT_THAT(whyNot(task), HasSubstr("The site of the mount is not set."));
    task = nightOfTwo();
    task.satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    EXPECT_EQ(whyNot(task), "The schedule has no pass within a day.");

    std::stop_source stop;
    const Result<RehearsedNight> stopped =
        rehearse(nightOfTwo(), stop.get_token(), [&](double) { stop.request_stop(); });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(textOf(stopped.error()), "The rehearsal was stopped.");
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
// A night of the schedule on a mount of ideal drives, in hand-turned time.
#include "core/night/night_desk.h"

#include "core/alarms/catalogue.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace boresight {
namespace {

using schedule::Moment;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const Site kNightSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile watching(std::vector<schedule::WatchEntry> list)
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kNightSite.latitude,
                    .longitude = kNightSite.longitude,
                    .heightMetres = kNightSite.heightMetres};
    profile.schedule.watch = std::move(list);
    profile.schedule.lead = Seconds(60.0);
    profile.control.tickHz = 20;  // the lowest: a night is long
    profile.control.watchdog = Seconds(0.2);
    profile.supervision.replyAge = Seconds(0.2);
    return profile;
}

// In a circular orbit, above 10° for the first time so long after now, for a time between these.
orbit::ElementSet risingAfter(int number, UtcTime now, std::chrono::minutes wait, Seconds shortest, Seconds longest)
{
    for (int node = 0; node < 360; node += 4) {
        for (int anomaly = 0; anomaly < 360; anomaly += 4) {
            orbit::ElementSet elements = fakes::lowOrbit(now, Angle::fromDegrees(node), Angle::fromDegrees(anomaly));
            elements.name = "SAT " + std::to_string(number);
            elements.number = number;
            const passes::PassList list =
                passes::findPasses(orbit::Sgp4(elements), {.site = kNightSite,
                                                           .from = now,
                                                           .to = now + std::chrono::minutes(60),
                                                           .minimumElevation = 10_deg,
                                                           .isClear = {}});
            if (list.passes.empty()) {
                continue;
            }
            const passes::Pass& pass = list.passes.front();
            if (std::chrono::abs(pass.aos.utc - now - wait) < std::chrono::minutes(1) && pass.duration() > shortest &&
                pass.duration() < longest && pass.tca.direction.elevation < 70_deg) {
                return elements;
            }
        }
    }
    ADD_FAILURE() << "no orbit has such a pass";
    return {};
}

// They are searched for once: each night begins at the same time.
NightDesk::Satellites threeSatellites()
{
    static const auto kSets = [] {
        const UtcTime begin = fakes::ManualClock().utc();
        std::vector<orbit::ElementSet> sets{
            risingAfter(90'001, begin, std::chrono::minutes(4), Seconds(240.0), Seconds(330.0))};
        for (int i = 1; i < 3; ++i) {
            sets.push_back(
                risingAfter(90'001 + i, begin, std::chrono::minutes(4 + 10 * i), Seconds(120.0), Seconds(180.0)));
        }
        return std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    }();
    return kSets;
}

class NightDeskTest : public ::testing::Test
{
protected:
    explicit NightDeskTest(profile::Profile profile = watching({{.number = 90'001, .priority = 2},
                                                                {.number = 90'002, .priority = 1},
                                                                {.number = 90'003, .priority = 3}}))
        : rig(profile)
    {
        desk.setSatellites(threeSatellites());
        run(Seconds(1.2));
    }

    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    void tick()
    {
        desk.tick();
        rig.tick();
    }
    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / rig.step); ++i) {
            tick();
        }
    }
    // Only while nothing moves or is about to: what is left out of the night.
    void skipTo(UtcTime utc)
    {
        ASSERT_GE(utc, now());
        rig.clock.setUtc(utc);
    }
    void skipToBefore(const schedule::WatchedPass& pass) { skipTo(pass.begins() - kBefore); }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            tick();
        }
    }
    [[nodiscard]] ScheduleStatus status() const
    {
        StationStatus all;
        desk.fill(all);
        return *all.schedule;
    }
    std::string arm(const Source& by = kOperator) { return answer(request::ArmSchedule{}, by); }
    std::string answer(const ScheduleRequest& wanted, const Source& by = kOperator)
    {
        const Result<> done = rig.ask(wanted, by).and_then([&] { return desk.carryOut(wanted, by); });
        return done ? std::string() : textOf(done.error());
    }
    // As the station hands it on.
    void operatorAsks(const Request& wanted)
    {
        ASSERT_TRUE(rig.ask(wanted));
        desk.noticed(wanted, kOperator);
    }
    [[nodiscard]] schedule::WatchedPass first() const { return status().plan.chosen.front(); }
    [[nodiscard]] bool logged(const char* words) const
    {
        return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); });
    }
    [[nodiscard]] std::vector<Moment> moments() const
    {
        std::vector<Moment> all;
        std::ranges::transform(told, std::back_inserter(all), &schedule::PassMoment::moment);
        return all;
    }
    void intoAPass()
    {
        ASSERT_EQ(arm(), "");
        ASSERT_FALSE(status().plan.chosen.empty());
        skipToBefore(first());
        runUntil(first().begins() + std::chrono::seconds(20));
        ASSERT_TRUE(status().tracked);
    }

    static constexpr std::chrono::seconds kBefore{65};  // more than the lead

    StationRig rig;
    std::vector<schedule::PassMoment> told;
    ReportFile file{QString()};
    NightDesk desk{rig.control,
                   rig.inForce,
                   file,
                   rig.clock,
                   rig.log,
                   [](const std::vector<passes::SatelliteSearch>& searches, const NightDesk::Found& found) {
                       found(passes::findPasses(searches));
                   },
                   [this](const schedule::PassMoment& moment) { told.push_back(moment); }};
};

// REQ-SCHEDULE-910: While it is armed the schedule sends the mount to each chosen pass, tracks it from AOS to LOS, and
// goes on to the next. The cable is never at its end. The report has each pass.
TEST_F(NightDeskTest, ANightOfSeveralPassesIsTracked)
{
    const std::vector<schedule::WatchedPass> plan = status().plan.chosen;
    ASSERT_GE(plan.size(), 3U);
    ASSERT_EQ(arm(), "");
    for (std::size_t i = 0; i < 3; ++i) {
        skipToBefore(plan[i]);
        runUntil(plan[i].pass.aos.utc - std::chrono::seconds(1));
        EXPECT_EQ(status().tracked, plan[i].number);
        EXPECT_TRUE(rig.control.onTarget(0.2_deg)) << "it is in place before the pass";
        const std::uint64_t lines = rig.log.lastNumber();
        while (now() < plan[i].pass.los.utc) {
            tick();
            ASSERT_FALSE(rig.control.limitedReason().contains(QLatin1String("travel")));
        }
        for (const LogEntry& line : rig.log.since(lines, EventLog::kCapacity)) {
            EXPECT_FALSE(line.text.contains(QLatin1String("turns back"))) << line.text.toStdString();
        }
        run(Seconds(1.0));
        EXPECT_FALSE(status().tracked);
        rig.settle();
    }
    const schedule::NightReport report = status().report;
    ASSERT_THAT(report.passes, SizeIs(3));
    EXPECT_EQ(report.done(), 3);
    EXPECT_EQ(report.interventions + report.faults, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        const schedule::PassRecord& pass = report.passes[i];
        const double lasts = Seconds(plan[i].pass.duration()).count();
        EXPECT_EQ(pass.number, plan[i].number);
        EXPECT_NEAR(pass.tracked.count(), lasts, 1.0);
        EXPECT_NEAR(pass.within1dB.count(), lasts, 1.0);
        EXPECT_NEAR(pass.within3dB.count(), lasts, 1.0);
        EXPECT_LT(pass.rmsError, 0.3_deg);
        EXPECT_LE(pass.rmsError, pass.peakError);
        EXPECT_EQ(pass.end, schedule::PassEnd::Set);
    }
}

// REQ-SCHEDULE-911: After a start the schedule is off, and nothing moves, also when a pass begins. Only the operator
// arms it. It is not armed without a watch list or a site.
TEST_F(NightDeskTest, NothingMovesUntilItIsArmed)
{
    EXPECT_FALSE(status().armed);
    const double azimuth = rig.azimuthDegrees();
    skipToBefore(first());
    runUntil(first().pass.aos.utc + std::chrono::seconds(30));
    EXPECT_NEAR(rig.azimuthDegrees(), azimuth, 0.01);
    EXPECT_NE(arm(kClient), "");
    EXPECT_EQ(rig.state(), StationState::Standby);
    profile::Profile none = rig.profile;
    none.schedule.watch.clear();
    rig.setProfile(none);
    EXPECT_EQ(arm(), "The watch list of the profile is empty.");
}

// REQ-SCHEDULE-912: STOP in a pass disarms the schedule: an alarm and a line of the log say so. Nothing moves after the
// reset of STOP, also not for the next pass.
TEST_F(NightDeskTest, StopDisarms)
{
    intoAPass();
    operatorAsks(request::Stop{});
    EXPECT_FALSE(status().armed);
    EXPECT_TRUE(rig.alarms.active(alarmEntry("schedule.disarmed")));
    EXPECT_TRUE(logged("the schedule is off: STOP of operator"));
    const schedule::NightReport report = status().report;
    ASSERT_THAT(report.passes, SizeIs(1));
    EXPECT_EQ(report.passes[0].end, schedule::PassEnd::Manual);
    EXPECT_EQ(report.interventions, 1);
    run(Seconds(5.0));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    const double azimuth = rig.azimuthDegrees();
    skipToBefore(status().plan.chosen[1]);
    runUntil(status().plan.chosen[1].pass.aos.utc + std::chrono::seconds(10));
    EXPECT_NEAR(rig.azimuthDegrees(), azimuth, 0.01);
}

// REQ-SCHEDULE-913: Any manual act disarms: a motion, Hold, control that is given away, STOP of a client. Armed again,
// the schedule goes on. A pass that is under way is then tracked for the rest.
TEST_F(NightDeskTest, AnyManualActDisarms)
{
    const std::vector<std::function<void()>> acts{
        [&] { operatorAsks(request::Hold{}); },
        [&] { operatorAsks(request::PointAxes{{.azimuth = 10_deg, .elevation = 20_deg}}); },
        [&] { operatorAsks(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}}); },
        [&] {
            ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
            run(Seconds(0.5));
            EXPECT_EQ(rig.control.authority(), Authority::Clients) << "it does not take it back";
        },
        [&] { ASSERT_TRUE(rig.ask(request::Stop{}, kClient)); },
    };
    intoAPass();
    int count = 0;
    for (const auto& act : acts) {
        act();
        run(Seconds(1.0));
        EXPECT_FALSE(status().armed);
        EXPECT_EQ(status().report.interventions, ++count);
        rig.settle();
        (void)rig.ask(request::ResetStop{});
        EXPECT_EQ(arm(), "");
        EXPECT_FALSE(rig.alarms.active(alarmEntry("schedule.disarmed")));
        run(Seconds(2.0));
        EXPECT_TRUE(status().tracked);
    }
}

// REQ-SCHEDULE-914: Disarming by the operator ends the pass, the mount holds, and there is no alarm.
TEST_F(NightDeskTest, TheOperatorDisarmsIt)
{
    intoAPass();
    EXPECT_EQ(answer(request::DisarmSchedule{}), "");
    EXPECT_FALSE(status().armed);
    EXPECT_FALSE(rig.alarms.active(alarmEntry("schedule.disarmed")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-SCHEDULE-917: What the mount cannot see is not planned: its horizon, keep-outs and limits count. A change of them
// makes a new plan. The parts that the antenna sees are tracked, and only they count in the report.
TEST_F(NightDeskTest, TheHorizonOfTheMountCounts)
{
    const auto draw = [&](double height) {
        const profile::Profile before = rig.profile;
        profile::Profile drawn = before;
        drawn.park.elevation = 90_deg;
        drawn.limits.horizon = {{.azimuth = 0_deg, .elevation = Angle::fromDegrees(height)},
                                {.azimuth = 180_deg, .elevation = Angle::fromDegrees(height)}};
        rig.setProfile(drawn);
        ASSERT_EQ(rig.inForce->limits, drawn.limits);
        desk.profileChanged(before, drawn);
        run(Seconds(1.2));
    };
    const schedule::WatchedPass whole = first();
    draw(89.9);
    EXPECT_THAT(status().plan.chosen, SizeIs(0));
    EXPECT_GE(status().plan.hidden.size(), 3U);

    draw(whole.pass.tca.direction.elevation.degrees() - 2.0);
    const schedule::WatchedPass top = first();
    EXPECT_LT(std::chrono::abs(top.pass.aos.utc - whole.pass.aos.utc), std::chrono::milliseconds(1));
    EXPECT_GT(top.begins(), whole.begins());
    EXPECT_LT(top.ends(), whole.ends());
    ASSERT_EQ(arm(), "");
    skipToBefore(top);
    runUntil(top.ends() + std::chrono::seconds(2));
    const schedule::NightReport report = status().report;
    ASSERT_THAT(report.passes, SizeIs(1));
    EXPECT_EQ(report.passes[0].end, schedule::PassEnd::Set);
    EXPECT_NEAR(report.passes[0].tracked.count(), top.pass.clearTime().count(), 1.0);
    EXPECT_NEAR(report.passes[0].within1dB.count(), top.pass.clearTime().count(), 1.0);
}

// REQ-SCHEDULE-918: After a restart the report of the same night goes on. A pass that the program left in the middle is
// in it. A report whose last pass ended a day ago is over, and a new one begins.
TEST_F(NightDeskTest, TheReportGoesOnAfterARestart)
{
    const auto reportNow = [&] {
        NightDesk again(rig.control, rig.inForce, file, rig.clock, rig.log, [](const auto&, const auto&) {});
        StationStatus all;
        again.fill(all);
        return all.schedule->report;
    };
    intoAPass();
    operatorAsks(request::Hold{});
    const schedule::NightReport before = status().report;
    ASSERT_THAT(before.passes, SizeIs(1));
    EXPECT_EQ(reportNow(), before);
    EXPECT_EQ(file.report().interventions, 1);

    rig.clock.stepUtc(NightDesk::kSameNight + Seconds(600.0));
    EXPECT_EQ(reportNow(), schedule::NightReport{});
}

// REQ-HOOKS-11
TEST_F(NightDeskTest, APassThatTheProgramLeavesIsInTheReport)
{
    {
        NightDesk other(
            rig.control, rig.inForce, file, rig.clock, rig.log,
            [](const std::vector<passes::SatelliteSearch>& searches, const NightDesk::Found& found) {
                found(passes::findPasses(searches));
            },
            [this](const schedule::PassMoment& moment) { told.push_back(moment); });
        other.setSatellites(threeSatellites());
        other.tick();
        ASSERT_TRUE(other.carryOut(request::ArmSchedule{}, kOperator));
        skipTo(first().begins() + std::chrono::seconds(5));
        other.tick();
        StationStatus all;
        other.fill(all);
        ASSERT_TRUE(all.schedule->tracked);
        EXPECT_TRUE(file.report().passes.empty());
    }
    ASSERT_THAT(file.report().passes, SizeIs(1));
    EXPECT_EQ(file.report().passes[0].end, schedule::PassEnd::Manual);
    EXPECT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Los));
}

// REQ-HOOKS-10: The moments of a pass are told once each, in order: before AOS, at AOS, at LOS. Each is a line of the
// log. While the schedule is not armed nothing is told.
TEST_F(NightDeskTest, TheMomentsOfAPassAreTold)
{
    const schedule::WatchedPass pass = first();
    skipTo(pass.begins() - std::chrono::seconds(80));
    run(Seconds(1.0));
    EXPECT_THAT(told, SizeIs(0));
    ASSERT_EQ(arm(), "");
    runUntil(pass.begins() + std::chrono::seconds(2));
    skipTo(pass.ends() - std::chrono::seconds(5));
    runUntil(pass.ends() + std::chrono::seconds(5));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Los));
    const std::array<UtcTime, 3> due{pass.begins() - std::chrono::seconds(60), pass.begins(), pass.ends()};
    for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_NEAR(Seconds(told[i].utc - due[i]).count(), 0.0, 0.1);
        EXPECT_EQ(told[i].pass, pass);
    }
    EXPECT_EQ(told[2].end, schedule::PassEnd::Set);
    EXPECT_TRUE(logged("the pass of SAT 90001 begins at"));
    EXPECT_TRUE(logged("AOS of SAT 90001"));
    EXPECT_TRUE(logged("LOS of SAT 90001"));
}

// REQ-HOOKS-11: A pass that was told to come is told to end, whatever ends it. Armed in the middle of a pass the
// moments that have passed are told at once.
TEST_F(NightDeskTest, WhatWasToldToComeIsToldToEnd)
{
    ASSERT_EQ(arm(), "");
    skipTo(first().begins() - std::chrono::seconds(30));
    run(Seconds(1.0));
    operatorAsks(request::Hold{});
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Los));
    EXPECT_EQ(told[1].end, schedule::PassEnd::Manual);
    EXPECT_EQ(told[1].why, QStringLiteral("operator has taken the mount"));
    EXPECT_TRUE(logged("the pass of SAT 90001 ends before its LOS"));
    told.clear();
    skipTo(first().begins() + std::chrono::seconds(20));
    ASSERT_EQ(arm(), "");
    run(Seconds(1.0));
    EXPECT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos));
    EXPECT_EQ(answer(request::DisarmSchedule{}), "");
    EXPECT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Los));
    told.clear();
    run(Seconds(5.0));
    EXPECT_THAT(told, SizeIs(0));
}

// REQ-HOOKS-11
TEST_F(NightDeskTest, APassThatIsNotPlannedAnyMoreIsToldToEnd)
{
    profile::Profile early = rig.profile;
    early.schedule.hooks.before = Seconds(300.0);
    rig.setProfile(early);
    ASSERT_EQ(arm(), "");
    skipTo(first().begins() - std::chrono::seconds(200));
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos));
    desk.setSatellites(std::make_shared<const std::vector<orbit::ElementSet>>());
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Los));
    EXPECT_EQ(told[1].end, schedule::PassEnd::Refused);
}

// REQ-HOOKS-12: A fault that ends the armed schedule is told, with the pass if there is one, which is told to end then.
// Without an armed schedule a fault is not told.
TEST_F(NightDeskTest, AFaultIsTold)
{
    intoAPass();
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 33;
    run(Seconds(1.0));
    ASSERT_THAT(moments(), ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Fault, Moment::Los));
    EXPECT_EQ(told[2].pass, told[1].pass);
    EXPECT_EQ(told[2].why, QStringLiteral("a fault ended the motion"));
    EXPECT_EQ(told[3].end, schedule::PassEnd::Fault);
    rig.elevation.mode = moteus::Mode::Fault;
    rig.elevation.fault = 33;
    run(Seconds(1.0));
    EXPECT_THAT(told, SizeIs(4)) << "it is not armed any more";
}

// Story: the mount waited for an hour where the satellite rises, and missed the passes of this hour.
// REQ-SCHEDULE-919: When the clock is set back the passes that come again are planned again. A pass that is tracked and
// now begins later is left with the reason, and tracked at its time.
TEST_F(NightDeskTest, AClockThatIsSetBackMakesANewPlan)
{
    const schedule::WatchedPass one = status().plan.chosen[0];
    const schedule::WatchedPass two = status().plan.chosen[1];
    ASSERT_EQ(arm(), "");
    skipToBefore(two);
    runUntil(two.begins() + std::chrono::seconds(2));
    ASSERT_EQ(status().tracked, two.number);
    rig.clock.setUtc(one.begins() - std::chrono::seconds(80));
    run(Seconds(1.0));
    EXPECT_FALSE(status().tracked);
    EXPECT_EQ(status().report.passes.back().end, schedule::PassEnd::Refused);
    EXPECT_TRUE(status().armed);
    ASSERT_FALSE(status().plan.chosen.empty());
    EXPECT_EQ(first().number, one.number);
    runUntil(one.begins() + std::chrono::seconds(2));
    EXPECT_EQ(status().tracked, one.number);
    rig.clock.stepUtc(Seconds(-10.0));
    run(Seconds(1.0));
    EXPECT_EQ(status().tracked, one.number) << "it is about to begin";
    skipTo(one.ends() - std::chrono::seconds(2));
    runUntil(one.ends() + std::chrono::seconds(5));
    skipToBefore(two);
    runUntil(two.begins() + std::chrono::seconds(2));
    EXPECT_EQ(status().tracked, two.number);
}

class UnattendedNight : public NightDeskTest
{
protected:
    static profile::Profile unattended()
    {
        profile::Profile profile = watching({{.number = 90'001}});
        profile.schedule.unattended = profile::Unattended::On;
        return profile;
    }
    UnattendedNight() : NightDeskTest(unattended()) {}
};

// REQ-SCHEDULE-915: The policy of the profile arms the schedule once after a start, with a line of the log. What
// somebody has disarmed stays off.
TEST_F(UnattendedNight, ThePolicyOfTheProfileArmsItOnce)
{
    EXPECT_TRUE(status().armed);
    EXPECT_TRUE(logged("armed by the profile"));
    operatorAsks(request::Hold{});
    run(Seconds(2.0));
    EXPECT_FALSE(status().armed);
}

}  // namespace
}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "core/units/angle_between.h"
#include "tests/core/night/night_desk_fixture.h"

#include <gmock/gmock.h>

#include <functional>

namespace boresight {
namespace {

using schedule::Moment;
using testing::ElementsAre;
using testing::SizeIs;

// REQ-SCHEDULE-910: While the schedule is armed it sends the mount to each chosen pass, tracks it from AOS to LOS, and
// goes on to the next. The cable never reaches its end. The report has each pass.
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
            EXPECT_FALSE(line.text.contains(QLatin1String("because the cable ends"))) << line.text.toStdString();
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

// REQ-SCHEDULE-911: After a start the schedule is not armed, and nothing moves, even when a pass begins. Only the
// operator arms it. It cannot be armed without a watch list or a site.
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

// The mount joins in the middle of a pass, far from its present position.
// REQ-SCHEDULE-922
TEST_F(NightDeskTest, APassThatIsJoinedLateHasTheErrorOfItsTracking)
{
    const schedule::WatchedPass pass = first();
    const UtcTime middle = pass.begins() + (pass.ends() - pass.begins()) / 2;
    skipTo(middle);
    ASSERT_EQ(arm(), "");
    run(Seconds(0.2));
    ASSERT_TRUE(status().tracked);
    EXPECT_GT(angleBetween(*rig.control.direction(), pass.pass.tca.direction), 20_deg);
    EXPECT_EQ(status().report.passes.back().peakError, std::nullopt);
    runUntil(pass.ends() + std::chrono::seconds(1));
    const schedule::PassRecord record = status().report.passes.back();
    EXPECT_EQ(record.end, schedule::PassEnd::Set);
    EXPECT_NEAR(record.tracked.count(), Seconds(pass.ends() - middle).count(), 1.0);
    EXPECT_LT(record.within3dB, record.tracked - Seconds(2.0)) << "what was missed";
    EXPECT_LT(record.peakError.value(), 0.5_deg);
    EXPECT_LT(record.rmsError.value(), 0.3_deg);
}

// REQ-SCHEDULE-912: STOP during a pass disarms the schedule, and an alarm and a log line report it. After the reset of
// STOP nothing moves, not even for the next pass.
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

// REQ-SCHEDULE-913: Any manual act disarms the schedule: a motion, Hold, handing over control, STOP of a client. When
// it is armed again the schedule continues, and the rest of a running pass is tracked.
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
        // Story: the S of a client was in the report as a fault without a name.
        [&] {
            ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
            run(Seconds(0.1));
            EXPECT_THAT(status().why.toStdString(), testing::HasSubstr(kClient.name.toStdString()));
        },
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

// REQ-SCHEDULE-914: When the operator disarms the schedule the pass ends, the mount holds, and there is no alarm.
TEST_F(NightDeskTest, TheOperatorDisarmsIt)
{
    intoAPass();
    EXPECT_EQ(answer(request::DisarmSchedule{}), "");
    EXPECT_FALSE(status().armed);
    EXPECT_FALSE(rig.alarms.active(alarmEntry("schedule.disarmed")));
    rig.settle();
    EXPECT_EQ(rig.state(), StationState::Hold);
}

// REQ-SCHEDULE-917: The plan leaves out what the mount cannot see: its horizon, keep-outs and limits count. A change of
// them makes a new plan. The parts of a pass that the antenna sees are tracked, and only these count in the report.
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

// REQ-SCHEDULE-918: After a restart the report of the same night continues. It includes the pass during which the
// program ended. A report whose last pass ended a day ago is complete, and a new report begins.
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

    rig.clock.stepUtc(ReportKeeper::kSameNight + Seconds(600.0));
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

// Story: the clock was set back. The mount waited for an hour where the satellite rises, and missed the passes of this
// hour.
// REQ-SCHEDULE-919: When the clock is set back, the passes that come again are planned again. If a tracked pass then
// begins later, its tracking ends with the reason, and it is tracked at its time.
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

// Two satellites of which the second sets later.
class OverlappingNight : public NightDeskTest
{
protected:
    static profile::Profile twoAtOnce()
    {
        profile::Profile profile = watching({{.number = 90'001, .priority = 1}, {.number = 90'004, .priority = 2}});
        profile.schedule.between = profile::BetweenPasses::Park;
        return profile;
    }
    OverlappingNight() : NightDeskTest(twoAtOnce())
    {
        const UtcTime begin = fakes::ManualClock().utc();
        std::vector<orbit::ElementSet> sets{*threeSatellites()->begin()};
        sets.push_back(risingAfter(90'004, begin, std::chrono::minutes(7), Seconds(300.0), Seconds(400.0)));
        desk.setSatellites(std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets)));
        run(Seconds(1.2));
    }
};

// Story: a client sent S while the mount parked between two passes, and the schedule sent it on to the next pass.
TEST_F(OverlappingNight, TheSOfAClientBetweenPassesDisarms)
{
    const UtcTime end = status().plan.chosen.at(1).ends();
    intoAPass();
    runUntil(end + std::chrono::milliseconds(500));
    ASSERT_TRUE(logged("park"));
    ASSERT_TRUE(rig.ask(request::Hold{}, kClient));
    run(Seconds(1.0));
    EXPECT_FALSE(status().armed);
    EXPECT_THAT(status().why.toStdString(), testing::HasSubstr(kClient.name.toStdString()));
    EXPECT_EQ(arm(), "");
    run(Seconds(1.0));
    EXPECT_TRUE(status().armed) << "the Hold came before";
}

// Story: the mount parked after the important satellite had set, while the other one was up for four minutes more.
// REQ-SCHEDULE-923: When a chosen pass ends while another watched satellite is up, the mount goes to that one at once,
// without parking, and tracks it for the rest of its pass. Report and moments have this rest as a pass of its own.
TEST_F(OverlappingNight, TheRestOfAPassIsTrackedAfterTheChosenOne)
{
    const schedule::WatchedPass chosen = first();
    const schedule::WatchedPass rest = status().plan.chosen.at(1);
    ASSERT_EQ(rest.number, 90'004);
    ASSERT_EQ(rest.rest.value().from, chosen.ends());
    ASSERT_THAT(status().plan.conflicts.front().rests, ElementsAre(*rest.rest));
    ASSERT_EQ(arm(), "");
    skipToBefore(chosen);
    runUntil(chosen.ends() + std::chrono::milliseconds(500));
    EXPECT_EQ(status().tracked, rest.number);
    EXPECT_FALSE(logged("park"));
    runUntil(rest.ends() - std::chrono::seconds(1));
    EXPECT_TRUE(rig.control.onTarget(0.2_deg));
    runUntil(rest.ends() + std::chrono::seconds(1));
    EXPECT_FALSE(status().tracked);
    EXPECT_TRUE(logged("park")) << "nothing is up any more";

    const schedule::NightReport report = status().report;
    ASSERT_THAT(report.passes, SizeIs(2));
    EXPECT_EQ(report.done(), 2);
    EXPECT_NEAR(report.passes[0].tracked.count(), Seconds(chosen.ends() - chosen.begins()).count(), 1.0);
    const schedule::PassRecord& part = report.passes[1];
    const double lasts = Seconds(rest.ends() - rest.begins()).count();
    EXPECT_EQ(part.aos, rest.begins());
    EXPECT_NEAR(part.tracked.count(), lasts, 1.0);
    EXPECT_GT(part.within3dB.count(), lasts - rig.profile.schedule.lead.count()) << "the way there is shorter";
    EXPECT_LT(part.rmsError.value(), 0.3_deg);
    EXPECT_THAT(moments(),
                ElementsAre(Moment::BeforeAos, Moment::Aos, Moment::Los, Moment::BeforeAos, Moment::Aos, Moment::Los));
    EXPECT_TRUE(logged("the tracked part of the pass of SAT 90004 begins"));
    EXPECT_TRUE(logged("the tracked part of the pass of SAT 90004 ends"));
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

// REQ-SCHEDULE-915: If the profile says so, the schedule is armed once after a start, with a line in the log. After
// somebody has disarmed it, it stays disarmed.
TEST_F(UnattendedNight, ThePolicyOfTheProfileArmsItOnce)
{
    EXPECT_TRUE(status().armed);
    EXPECT_TRUE(logged("armed by the profile"));
    operatorAsks(request::Hold{});
    run(Seconds(2.0));
    EXPECT_FALSE(status().armed);
}

// REQ-WIND-30: A pass that the wind ends, or that begins in a strong wind, is in the report with the reason. The
// schedule stays armed and goes on with the next pass after the wind.
TEST_F(NightDeskTest, TheWindCostsAPassAndTheScheduleGoesOn)
{
    profile::Profile windy = rig.profile;
    windy.wind.source = "udp:4541";
    windy.wind.calm = 1.0;
    rig.setProfile(windy);
    const auto blow = [&](double speed, Seconds time) {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            rig.control.takeWind(speed);
            run(Seconds(1.0));
        }
    };
    blow(5.0, Seconds(1.0));
    intoAPass();
    ASSERT_TRUE(status().tracked);
    blow(17.0, Seconds(60.0));
    EXPECT_TRUE(status().armed);
    EXPECT_FALSE(status().tracked);
    EXPECT_EQ(rig.state(), StationState::Parked);
    ASSERT_THAT(status().report.passes, SizeIs(1));
    EXPECT_EQ(status().report.passes[0].end, schedule::PassEnd::Refused);
    EXPECT_EQ(status().report.passes[0].why, QStringLiteral("The wind reached 17.0 m/s. The limit is 15.0 m/s."));
    const std::vector<schedule::WatchedPass> plan = status().plan.chosen;
    ASSERT_GE(plan.size(), 3U);
    skipToBefore(plan[1]);
    while (now() < plan[1].ends() + std::chrono::seconds(2)) {
        blow(17.0, Seconds(1.0));
    }
    ASSERT_THAT(status().report.passes, SizeIs(2));
    EXPECT_EQ(status().report.passes[1].end, schedule::PassEnd::Refused);
    EXPECT_TRUE(status().report.passes[1].why.startsWith(QStringLiteral("The wind reached 17.0 m/s.")));
    blow(5.0, Seconds(65.0));
    EXPECT_EQ(rig.state(), StationState::Parked) << "nothing moves by itself";
    skipToBefore(plan[2]);
    while (now() < plan[2].pass.aos.utc + std::chrono::seconds(5)) {
        blow(5.0, Seconds(1.0));
    }
    EXPECT_EQ(status().tracked, plan[2].number);
    EXPECT_TRUE(rig.control.onTarget(0.2_deg));
}

}  // namespace
}  // namespace boresight

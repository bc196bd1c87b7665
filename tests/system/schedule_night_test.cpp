// SPDX-License-Identifier: GPL-3.0-or-later
// Nights with the schedule on the simulated mount: every pass from its rise to its set, with the elements from a file.
#include "core/elements/julian_date.h"
#include "core/inputs/station_elements.h"
#include "core/night/tracked_pass.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/random_region.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/simulated_station.h"

#include <QDateTime>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

namespace boresight::system_test {
namespace {

using namespace std::chrono_literals;
using schedule::PassEnd;
using schedule::PassRecord;
using schedule::WatchedPass;

constexpr int kSatellites = 6;
constexpr int kFirstNumber = 90'001;
constexpr int kPasses = 20;
constexpr Seconds kLead{60.0};
constexpr auto kBefore = 63s;         // the program before AOS and the lead start later
constexpr Angle kFromTheEnd = 2_deg;  // distance of the cable from its end
constexpr Seconds kReported{1.5};     // allowed difference between the report and the observation

// Satellites on different orbits, so that passes come all night, and some at the same time.
std::vector<orbit::ElementSet> satellites(UtcTime epoch)
{
    std::vector<orbit::ElementSet> sets;
    for (int i = 0; i < kSatellites; ++i) {
        orbit::ElementSet set =
            fakes::lowOrbit(epoch, Angle::fromDegrees(57.0 * i), Angle::fromDegrees(131.0 * i + 20.0));
        set.number = kFirstNumber + i;
        set.name = "SAT " + std::to_string(set.number);
        sets.push_back(set);
    }
    return sets;
}

QByteArray asCsv(const std::vector<orbit::ElementSet>& sets)
{
    QByteArray text =
        "OBJECT_NAME,EPOCH,MEAN_MOTION,ECCENTRICITY,INCLINATION,RA_OF_ASC_NODE,ARG_OF_PERICENTER,MEAN_ANOMALY,"
        "NORAD_CAT_ID,BSTAR,MEAN_MOTION_DOT,MEAN_MOTION_DDOT\n";
    for (const orbit::ElementSet& set : sets) {
        const auto epoch = std::chrono::round<std::chrono::seconds>(orbit::utcTime(set.epoch).time_since_epoch());
        text += QStringLiteral("%1,%2,%3,%4,%5,%6,%7,%8,%9,%10,0,0\n")
                    .arg(QString::fromStdString(set.name), QDateTime::fromSecsSinceEpoch(epoch.count(), Qt::UTC)
                                                               .toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss")))
                    .arg(set.revolutionsPerDay, 0, 'f', 8)
                    .arg(set.eccentricity, 0, 'f', 7)
                    .arg(set.inclination.degrees(), 0, 'f', 4)
                    .arg(set.ascendingNode.degrees(), 0, 'f', 4)
                    .arg(set.perigee.degrees(), 0, 'f', 4)
                    .arg(set.meanAnomaly.wrapped360().degrees(), 0, 'f', 4)
                    .arg(set.number)
                    .arg(set.bstar, 0, 'e', 4)
                    .toLatin1();
    }
    return text;
}

// Hills of 8° in the south.
profile::Profile nightProfile(const QString& elements, const QString& hooks)
{
    profile::Profile profile = anyPort();
    profile.control.tickHz = 20;
    profile.control.watchdog = Seconds(0.2);
    profile.supervision.replyAge = Seconds(0.2);
    profile.site = {
        .known = true, .latitude = 38.757_deg, .longitude = Angle::fromDegrees(-9.117), .heightMetres = 80.0};
    profile.limits.horizon = {{90_deg, 2_deg}, {120_deg, 8_deg}, {240_deg, 8_deg}, {270_deg, 2_deg}};
    profile.park = {.azimuth = 180_deg, .elevation = 45_deg};
    profile.orbit.elements = {elements.toStdString()};
    profile.schedule.lead = kLead;
    for (int i = 0; i < kSatellites; ++i) {
        profile.schedule.watch.push_back({.number = kFirstNumber + i,
                                          .priority = 1 + i % 3,
                                          .leastElevation = Angle::fromDegrees(i % 2 == 0 ? 10.0 : 25.0)});
    }
    const profile::Command command{"/bin/sh", "-c", "echo $BORESIGHT_EVENT $BORESIGHT_NORAD $BORESIGHT_END >>\"$0\"",
                                   hooks.toStdString()};
    profile.schedule.hooks = {.beforeAos = command, .aos = command, .los = command, .fault = command};
    return profile;
}

class ScheduleNight : public ::testing::Test
{
protected:
    ScheduleNight()
    {
        write(asCsv(m_sets));
        rig = std::make_unique<SimulatedStation>(nightProfile(elementsPath(), hooksPath()),
                                                 sim::commissionedPair({.azimuth = 180_deg, .elevation = 45_deg}));
        timers = std::make_unique<fakes::HandTurnedTimers>(*rig->station->findChild<StationElements*>(), rig->clock);
        rig->onTick = [this] { look(); };
        EXPECT_TRUE(fakes::waitUntil([&] {
            rig->tick();
            return night().plan.chosen.size() >= kPasses;
        }));
    }
    ~ScheduleNight() override
    {
        EXPECT_LT(m_deepest, 0.2) << "of the antenna below the horizon";
        EXPECT_GT(m_nearestEnd, kFromTheEnd) << m_nearestEnd.degrees();
    }

    [[nodiscard]] QString elementsPath() const { return m_folder.filePath(QStringLiteral("night.csv")); }
    [[nodiscard]] QString hooksPath() const { return m_folder.filePath(QStringLiteral("hooks")); }
    void write(const QByteArray& text) const
    {
        QFile file(elementsPath());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    [[nodiscard]] UtcTime now() const { return rig->clock.utc(); }
    [[nodiscard]] ScheduleStatus night() const { return *rig->status().schedule; }
    [[nodiscard]] WatchedPass nextPass() const
    {
        const std::vector<WatchedPass> chosen = night().plan.chosen;
        const auto followsAtOnce = [&](const WatchedPass& one) {
            return one.rest && one.begins() == m_over && one.ends() > now();
        };
        const auto found = std::ranges::find_if(
            chosen, [&](const WatchedPass& one) { return one.begins() > now() || followsAtOnce(one); });
        EXPECT_NE(found, chosen.end());
        return found == chosen.end() ? WatchedPass{} : *found;
    }
    // Skips the time in which nothing moves, up to the next pass. The rest of a pass begins without such a time.
    void goToNext()
    {
        const WatchedPass pass = nextPass();
        if (now() < pass.begins() - kBefore) {
            EXPECT_TRUE(rig->settle());
            rig->clock.setUtc(pass.begins() - kBefore);
        }
        seen.emplace(pass, elementsOf(pass.number), nightSite(), rig->clock.now());
    }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            rig->tick();
        }
    }
    // Runs until the pass is over. `inItsMiddle` is called halfway.
    PassRecord track(const std::function<void()>& inItsMiddle = {})
    {
        goToNext();
        const WatchedPass pass = seen->pass();
        runUntil(pass.begins() - 1s);
        EXPECT_EQ(night().tracked, pass.number);
        if (inItsMiddle) {
            runUntil(pass.begins() + (pass.ends() - pass.begins()) / 2);
            inItsMiddle();
        }
        runUntil(pass.ends() + 1s);
        EXPECT_NE(night().tracked, pass.number);
        const PassRecord truth = seen->tally().record();
        seen.reset();
        m_over = pass.ends();
        m_isRest = pass.rest.has_value();
        return truth;
    }
    // The report without passes that are still tracked: the rest of another pass may go on.
    [[nodiscard]] schedule::NightReport report() const
    {
        schedule::NightReport report = night().report;
        std::erase_if(report.passes, [](const PassRecord& pass) { return pass.end == PassEnd::Running; });
        return report;
    }
    [[nodiscard]] bool wasRest() const { return m_isRest; }  // what was tracked last
    [[nodiscard]] Site nightSite() const { return rig->status().profile->site.place(); }
    [[nodiscard]] const orbit::ElementSet& elementsOf(std::int64_t number) const
    {
        return m_sets.at(static_cast<std::size_t>(number - kFirstNumber));
    }
    // The lines that the programs of the profile have written, when all have ended.
    [[nodiscard]] std::vector<std::string> hooks(std::size_t count) const
    {
        std::vector<std::string> lines;
        EXPECT_TRUE(fakes::waitUntil([&] {
            QFile file(hooksPath());
            lines.clear();
            if (file.open(QIODevice::ReadOnly)) {
                for (const QByteArray& line : file.readAll().split('\n')) {
                    lines.push_back(line.trimmed().toStdString());
                }
                lines.pop_back();
            }
            return lines.size() >= count;
        }));
        return lines;
    }

    std::unique_ptr<SimulatedStation> rig;
    std::unique_ptr<fakes::HandTurnedTimers> timers;
    std::optional<TrackedPass> seen;  // by the true position of the antenna

private:
    void look()
    {
        timers->runDue();
        const AxisPosition truth = rig->truth();
        const profile::Profile& profile = m_profile;
        m_deepest = std::max(m_deepest, fakes::depthInside(profile.limits, truth));
        const TravelRange& travel = profile.azimuth.geometry.travel;
        m_nearestEnd = std::min({m_nearestEnd, truth.azimuth - travel.min, travel.max - truth.azimuth});
        if (seen) {
            // To the rest of a pass the mount is on its way while it counts already.
            const bool isThere = !seen->pass().rest || rig->status().state == StationState::Track;
            seen->look({.direction = SkyPointing{.azimuth = truth.azimuth.wrapped360(), .elevation = truth.elevation},
                        .isOnTarget = isThere},
                       now(), rig->clock.now(), {.beamWidth = profile.mount.beamWidth});
        }
    }

    QTemporaryDir m_folder;
    std::vector<orbit::ElementSet> m_sets = satellites(fakes::ManualClock().utc());
    const profile::Profile m_profile = nightProfile({}, {});
    double m_deepest = -90.0;
    Angle m_nearestEnd = 360_deg;
    UtcTime m_over{};  // the last pass
    bool m_isRest = false;
};

void expectLikeTruth(const PassRecord& reported, const PassRecord& truth)
{
    EXPECT_EQ(reported.number, truth.number);
    EXPECT_NEAR(reported.tracked.count(), truth.tracked.count(), kReported.count());
    EXPECT_NEAR(reported.within1dB.count(), truth.within1dB.count(), kReported.count());
    EXPECT_NEAR(reported.within3dB.count(), truth.within3dB.count(), kReported.count());
    ASSERT_TRUE(reported.rmsError && truth.rmsError && reported.peakError && truth.peakError);
    EXPECT_NEAR(reported.rmsError->degrees(), truth.rmsError->degrees(), 0.05);
    EXPECT_NEAR(reported.peakError->degrees(), truth.peakError->degrees(), 0.1);
}

// REQ-SCHEDULE-930: In a night of 20 passes each is tracked from its rise to its set, within 1 dB of the beam. The rest
// of a pass is tracked as soon as the mount is there. The report agrees with the true motion. The cable never reaches
// its end, and the antenna never goes below the horizon. The programs of the profile run at each of their moments.
TEST_F(ScheduleNight, TwentyPassesAreTracked)
{
    EXPECT_FALSE(night().plan.conflicts.empty());
    ASSERT_EQ(rig->ask(request::ArmSchedule{}), "");
    std::vector<PassRecord> truths;
    std::vector<bool> rests;
    for (int i = 0; i < kPasses; ++i) {
        truths.push_back(track());
        rests.push_back(wasRest());
    }
    const schedule::NightReport all = report();
    ASSERT_EQ(all.passes.size(), truths.size());
    EXPECT_EQ(all.done(), kPasses);
    EXPECT_EQ(all.interventions + all.faults, 0);
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const PassRecord& pass = all.passes[i];
        expectLikeTruth(pass, truths[i]);
        EXPECT_GT(pass.within1dB, pass.tracked - (rests[i] ? kLead : kReported));
        EXPECT_GT(pass.tracked, 50s);
        EXPECT_LT(pass.rmsError, 0.2_deg);
    }
    EXPECT_TRUE(night().armed);
    EXPECT_FALSE(rig->alarmSays(QStringLiteral("schedule")));
    EXPECT_GE(hooks(3 * kPasses).size(), 3U * kPasses);
}

// REQ-SCHEDULE-931: A night has a drive fault, an unplugged bus, a clock that is set, and elements that disappear. Only
// the passes hit by them are lost. Each of these events is in the report and in the log, the mount waits for the
// operator where it must, and the next pass is tracked.
TEST_F(ScheduleNight, ANightOfTroublesGoesOn)
{
    const auto onceMore = [&] {
        EXPECT_EQ(rig->ask(request::Rearm{}), "");
        rig->run(Seconds(2.0));
        EXPECT_EQ(rig->ask(request::ArmSchedule{}), "");
    };
    const auto fails = [&](const sim::Injection& injection, Seconds duration, const char* words) {
        EXPECT_TRUE(night().armed);
        const auto handle = rig->link->inject(injection);
        rig->run(duration);
        rig->link->pair().faults().remove(handle);
        EXPECT_FALSE(night().armed);
        EXPECT_TRUE(rig->alarmSays(QStringLiteral("schedule of passes is off")));
        EXPECT_TRUE(rig->logSays(QLatin1String(words)));
        EXPECT_EQ(report().passes.back().end, PassEnd::Fault);
        const AxisPosition stands = rig->truth();
        rig->run(Seconds(10.0));
        EXPECT_LT(rig->farthestFrom(stands), 0.5_deg) << "nobody has re-armed";
        onceMore();
    };
    // The mount continues with the old time until the operator wants the new time.
    const auto setClock = [&](Seconds by) {
        rig->clock.stepUtc(by);
        rig->tick();
        EXPECT_TRUE(rig->alarmSays(QStringLiteral("The clock of this computer was set by")));
        EXPECT_EQ(rig->ask(request::UseNewTime{}), "");
        EXPECT_TRUE(rig->logSays(QStringLiteral("uses the new time of this computer")));
    };
    ASSERT_EQ(rig->ask(request::ArmSchedule{}), "");
    (void)track();
    (void)track([&] {
        fails({.kind = sim::FaultKind::DriveFault, .axis = Axis::Azimuth, .value = 33.0}, Seconds(1.0),
              "the schedule is off: a fault ended the motion");
    });
    ASSERT_TRUE(night().armed);
    EXPECT_EQ(report().faults, 1);
    EXPECT_EQ(report().passes.back().end, PassEnd::Set) << "what was left of it";
    (void)track();
    (void)track([&] { fails({.kind = sim::FaultKind::BusOff}, Seconds(8.0), "the schedule is off: "); });
    ASSERT_TRUE(night().armed);
    EXPECT_EQ(report().faults, 2);
    EXPECT_EQ(report().passes.back().end, PassEnd::Set);
    EXPECT_GE(hooks(20).size(), 20U);

    while (nextPass().rest || nextPass().ends() - nextPass().begins() < 250s) {
        (void)track();
    }
    const PassRecord hurried = track([&] { setClock(Seconds(90.0)); });
    expectLikeTruth(report().passes.back(), hurried);
    EXPECT_EQ(report().passes.back().end, PassEnd::Set);
    ASSERT_TRUE(night().armed);

    ASSERT_TRUE(QFile::remove(elementsPath()));
    (void)track();
    EXPECT_TRUE(rig->logSays(QStringLiteral("6 satellites are missing there. They keep")));
    write("<html>503 Service Unavailable</html>");
    (void)track();
    EXPECT_TRUE(rig->logSays(QStringLiteral("There is no element set in this file")));
    write(asCsv(satellites(fakes::ManualClock().utc())));
    (void)track();

    goToNext();
    const WatchedPass left = seen->pass();
    runUntil(left.begins() + 30s);
    seen.reset();
    setClock(Seconds(-3600.0));
    rig->run(Seconds(2.0));
    EXPECT_FALSE(night().tracked == left.number && left.begins() - now() > kLead);
    EXPECT_EQ(report().passes.back().end, PassEnd::Refused);
    EXPECT_TRUE(rig->logSays(QStringLiteral("was set back by 3600.0 s")));
    EXPECT_TRUE(night().armed);
    const std::size_t before = report().passes.size();
    while (night().armed && nextPass().begins() < left.begins() + schedule::kSamePass) {
        (void)track();
    }
    EXPECT_EQ(report().passes.back().number, left.number) << "at its time";
    while (night().armed && report().done() < kPasses) {
        const PassRecord truth = track();
        expectLikeTruth(report().passes.back(), truth);
    }
    for (std::size_t i = before; i < report().passes.size(); ++i) {
        EXPECT_EQ(report().passes[i].end, PassEnd::Set);
    }
    EXPECT_EQ(report().done(), kPasses);
    EXPECT_EQ(report().faults, 2);
}

}  // namespace
}  // namespace boresight::system_test

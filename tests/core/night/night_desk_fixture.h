// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/night/night_desk.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

// A night of the schedule on a mount with ideal drives, in hand-turned time.
namespace boresight {

inline const Site kNightSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

inline profile::Profile watching(std::vector<schedule::WatchEntry> list)
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kNightSite.latitude,
                    .longitude = kNightSite.longitude,
                    .heightMetres = kNightSite.heightMetres};
    profile.schedule.watch = std::move(list);
    profile.schedule.lead = Seconds(60.0);
    profile.control.tickHz = 20;  // the lowest, because a night is long
    profile.control.watchdog = Seconds(0.2);
    profile.supervision.replyAge = Seconds(0.2);
    return profile;
}

// A satellite in a circular orbit that first rises above 10° after about `wait`, for a time between these limits.
inline orbit::ElementSet risingAfter(int number, UtcTime now, std::chrono::minutes wait, Seconds shortest,
                                     Seconds longest)
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

// The search runs only once, because every night begins at the same time.
inline NightDesk::Satellites threeSatellites()
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
    // Skips time. Only allowed while nothing moves or is about to move.
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
    // Passes the request on as the station does.
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
    [[nodiscard]] std::vector<schedule::Moment> moments() const
    {
        std::vector<schedule::Moment> all;
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

}  // namespace boresight

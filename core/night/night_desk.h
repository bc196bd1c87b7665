// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/control/station_control.h"
#include "core/messages/request.h"
#include "core/messages/schedule_status.h"
#include "core/night/pass_moments.h"
#include "core/night/report_keeper.h"
#include "core/night/tracked_pass.h"
#include "core/passes/pass_finder.h"
#include "core/profile/in_force.h"
#include "core/sources/steered_utc.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

// Runs the schedule: plans the passes of the watch list, and while it is armed sends the mount to each of them, unwinds
// or parks it in between, and keeps the report. It stands beside StationControl and moves the mount only by asking it,
// so limits, STOP, faults and authority hold for it like for everybody. It is off after each start; only a person arms
// it, or the written policy of the profile, once. Whatever else is done with the mount disarms it. Station thread.
//
// More than 15 members: what it stands beside, the plan with what it was made of, and what goes on.
namespace boresight {

// Who asks for the motions of the schedule.
[[nodiscard]] const Source& scheduleSource();

// What only looks, or speaks for nobody who wants the mount.
[[nodiscard]] bool leavesTheMount(const Request& request);

class NightDesk
{
public:
    using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;  // in the order of the numbers
    using Found = std::function<void(const std::vector<passes::PassList>&)>;
    // Searches beside the station thread, and reports what it found on the station thread.
    using Search = std::function<void(std::vector<passes::SatelliteSearch>, Found)>;

    static constexpr std::chrono::hours kPlanned{24};
    static constexpr std::chrono::hours kRenewed{1};
    // What does not follow within this time is not waited for: the mount may be parked.
    static constexpr std::chrono::minutes kLongPause{30};

    // All of them outlive the desk.
    NightDesk(StationControl& control, const profile::InForce& profile, ReportFile& file, const Clock& clock,
              EventLog& log, Search search, PassMoments::Tell tell = {});
    ~NightDesk();  // a pass that goes on comes into the report
    NightDesk(const NightDesk&) = delete;
    NightDesk& operator=(const NightDesk&) = delete;

    // What StationControl has admitted: done, or the reason why not.
    Result<> carryOut(const ScheduleRequest& request, const Source& by);
    // StationControl has admitted this of somebody else. A manual act disarms.
    void noticed(const Request& request, const Source& by);
    void setSatellites(const Satellites& satellites);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Once per tick, before StationControl's.
    void tick();

    [[nodiscard]] const std::shared_ptr<const ScheduleStatus>& status() const { return m_shown; }
    // Its part of the station's.
    void fill(StationStatus& status) const;

private:
    struct Interruption
    {
        schedule::PassEnd end;
        QString why;
    };

    [[nodiscard]] Result<> mayArm() const;
    Result<> arm(const Source& by, Severity severity, const QString& words);
    void armByPolicy();
    void disarm(const Interruption& by);
    [[nodiscard]] std::optional<Interruption> interruption() const;
    void waitOutWind();
    void noticeClock();
    void lookForPasses();
    [[nodiscard]] std::function<bool(const SkyPointing&)> clearSkyOf(std::int64_t satellite) const;
    void plan(const std::vector<schedule::WatchedPass>& known, const std::vector<passes::PassList>& found);
    [[nodiscard]] const schedule::WatchedPass* next() const;
    void move();
    void begin(const schedule::WatchedPass& pass);
    void finish(schedule::PassEnd end, const QString& why);
    void holdNow();
    void restBetween();
    Result<> ask(const Request& request);
    void show();

    StationControl& m_control;
    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    Search m_search;
    Satellites m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    std::uint64_t m_searches = 0;               // the number of the last one
    std::optional<SteadyTime> m_searched = {};  // empty: what it was made of has changed
    schedule::NightPlan m_plan;
    QString m_missing;  // what cannot be planned, in words
    bool m_armed = false;
    bool m_policyUsed = false;  // or somebody has acted since the start
    QString m_why;              // it was disarmed
    std::uint64_t m_errand = 0;
    UtcTime m_handledUntil{};  // passes that end before are over
    sources::SteeredUtc m_utc;
    std::optional<TrackedPass> m_tracked;
    PassMoments m_moments;
    ReportKeeper m_report;
    std::shared_ptr<const ScheduleStatus> m_shown = std::make_shared<const ScheduleStatus>();
    SteadyTime m_shownAt{};
};

}  // namespace boresight

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

// Runs the schedule: plans the passes of the watch list. While the schedule is armed, it sends the mount to each pass,
// unwraps or parks it in between, and keeps the report. It stands beside StationControl and moves the mount only by
// requests to it, so limits, STOP, faults and authority apply as for everybody. After each start the schedule is not
// armed. A person arms it, or the profile permits that it is armed once automatically. Any other use of the mount
// disarms it. Station thread.
//
// It has more than 15 members: the objects that it works with, the plan and its inputs, and the present pass.
namespace boresight {

// The source of all motions of the schedule.
[[nodiscard]] const Source& scheduleSource();

// Requests that only read, or that do not concern the mount.
[[nodiscard]] bool leavesTheMount(const Request& request);

class NightDesk
{
public:
    using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;  // in the order of the numbers
    using Found = std::function<void(const std::vector<passes::PassList>&)>;
    // Searches on another thread, and calls `Found` on the station thread.
    using Search = std::function<void(std::vector<passes::SatelliteSearch>, Found)>;

    static constexpr std::chrono::hours kPlanned{24};
    static constexpr std::chrono::hours kRenewed{1};
    // In a longer pause the mount may be parked.
    static constexpr std::chrono::minutes kLongPause{30};

    // All arguments must outlive this object.
    NightDesk(StationControl& control, const profile::InForce& profile, ReportFile& file, const Clock& clock,
              EventLog& log, Search search, PassMoments::Tell tell = {});
    ~NightDesk();  // writes a pass in progress into the report
    NightDesk(const NightDesk&) = delete;
    NightDesk& operator=(const NightDesk&) = delete;

    // Carries out a request that StationControl has admitted. Returns why, if it cannot.
    Result<> carryOut(const ScheduleRequest& request, const Source& by);
    // Call it when StationControl has admitted a request of somebody else. A manual act disarms.
    void noticed(const Request& request, const Source& by);
    void setSatellites(const Satellites& satellites);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Once per tick, before the tick of StationControl.
    void tick();

    [[nodiscard]] const std::shared_ptr<const ScheduleStatus>& status() const { return m_shown; }
    // Fills in the schedule's part of the status.
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
    std::uint64_t m_searches = 0;               // the number of the last search
    std::optional<SteadyTime> m_searched = {};  // empty: the inputs have changed since
    schedule::NightPlan m_plan;
    QString m_missing;  // what cannot be planned, in words
    bool m_armed = false;
    bool m_policyUsed = false;  // the policy was used, or a person has acted since the start
    QString m_why;              // why the schedule was disarmed
    std::uint64_t m_motionId = 0;
    bool m_heldBefore = false;  // nothing has moved since a Hold that came before the schedule was armed
    UtcTime m_handledUntil{};   // passes that end before this time are over
    sources::SteeredUtc m_utc;
    std::optional<TrackedPass> m_tracked;
    PassMoments m_moments;
    ReportKeeper m_report;
    std::shared_ptr<const ScheduleStatus> m_shown = std::make_shared<const ScheduleStatus>();
    SteadyTime m_shownAt{};
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rehearsal/rehearsal.h"

#include "core/alarms/alarm_board.h"
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/perfect_mount/perfect_mount.h"
#include "core/rehearsal/turned_clock.h"
#include "core/sources/motion_sources.h"

#include <algorithm>
#include <limits>

namespace boresight {
namespace {

// A control loop with this rate is fast enough for every motion, and fewer ticks make the rehearsal shorter.
constexpr int kTickHz = 20;
constexpr Seconds kRehearsalPatience{0.2};  // longer than a few ticks
constexpr std::chrono::nanoseconds kTick = std::chrono::nanoseconds(std::chrono::seconds(1)) / kTickHz;
// The time that the control needs to take over the mount.
constexpr std::chrono::seconds kBegin{2};
constexpr std::chrono::minutes kBetweenIdleLooks{1};
// While the mount stands and no pass is near, only this part of each minute is computed.
constexpr std::chrono::milliseconds kLook{500};
constexpr std::size_t kMostRemarks = 200;
const Source kRehearser{.kind = SourceKind::Operator, .name = QStringLiteral("operator")};

// The profile in force, without the settings for real drives, their brake and their end switches, and for the absence
// of the operator.
profile::Profile rehearsed(profile::Profile profile)
{
    profile.control.tickHz = kTickHz;
    profile.control.watchdog = kRehearsalPatience;
    profile.supervision.replyAge = kRehearsalPatience;
    profile.schedule.unattended = profile::Unattended::Off;
    profile.brake = {};
    profile.endSwitches = {};
    return profile;
}

AxisSet axesOf(const profile::Profile& profile)
{
    return axesIf(profile.azimuth.driver != profile::AxisDriver::None,
                  profile.elevation.driver != profile::AxisDriver::None);
}

// The deciding parts of a station, with a clock, a log and a mount of their own.
class Stage
{
public:
    Stage(const RehearsalTask& task, const std::stop_token& stop)
        : m_clock(task.from),
          m_profile(rehearsed(task.profile)),
          m_mount(axesOf(task.profile), task.standing),
          m_control(m_profile, m_clock, m_log, m_alarms, m_mount, motionSources),
          m_desk(m_control, m_profile, m_report, m_clock, m_log,
                 [stop](const std::vector<passes::SatelliteSearch>& searches, const NightDesk::Found& found) {
                     found(passes::findPasses(searches, stop));
                 })
    {
        [[maybe_unused]] const Result<> used = m_control.request(request::UseAntenna{task.antenna}, kRehearser);
        m_desk.setSatellites(task.satellites);
        m_night.from = task.from;
        m_night.leastAzimuth = m_night.mostAzimuth = task.standing.azimuth;
    }

    // Advances to the next look.
    void goOn()
    {
        const bool idle = isIdle();
        if (idle) {
            m_clock.skip(kBetweenIdleLooks - kLook);
        }
        run(idle ? kLook : kBetweenIdleLooks);
    }

    void run(std::chrono::nanoseconds time)
    {
        for (std::chrono::nanoseconds done{0}; done < time; done += kTick) {
            m_clock.advance(kTick);
            m_desk.tick();
            m_control.tick();
            const Angle azimuth = m_mount.report(Axis::Azimuth).place.value_or(Angle{});
            m_night.leastAzimuth = std::min(m_night.leastAzimuth, azimuth);
            m_night.mostAzimuth = std::max(m_night.mostAzimuth, azimuth);
        }
        takeRemarks();
    }

    Result<> arm() { return m_desk.carryOut(request::ArmSchedule{}, kRehearser); }

    [[nodiscard]] UtcTime utc() const { return m_clock.utc(); }
    [[nodiscard]] const ScheduleStatus& schedule() const { return *m_desk.status(); }

    [[nodiscard]] RehearsedNight night(const schedule::NightPlan& plan) const
    {
        RehearsedNight night = m_night;
        night.to = utc();
        night.plan = plan;
        night.report = schedule().report;
        night.disarmed = schedule().armed ? QString() : schedule().why;
        return night;
    }

private:
    [[nodiscard]] bool isIdle() const
    {
        const auto stands = [&](Axis axis) {
            return m_mount.report(axis).rate.value_or(AngularRate{}) == AngularRate{};
        };
        const UtcTime soon =
            utc() + 2 * kBetweenIdleLooks + std::chrono::ceil<std::chrono::seconds>(m_profile->schedule.lead);
        const auto isNear = [&](const schedule::WatchedPass& pass) {
            return pass.begins() < soon && pass.ends() > utc();
        };
        return !schedule().tracked && std::ranges::all_of(kAxes, stands) &&
               std::ranges::none_of(schedule().plan.chosen, isNear);
    }

    void takeRemarks()
    {
        for (const LogEntry& entry : m_log.since(m_read, EventLog::kCapacity)) {
            m_read = entry.number;
            if (entry.severity != Severity::Advisory && m_night.remarks.size() < kMostRemarks) {
                m_night.remarks.push_back({.utc = entry.utc, .text = entry.text});
            }
        }
    }

    TurnedClock m_clock;
    profile::InForce m_profile;
    EventLog m_log{m_clock, EventLog::Echo::No};
    AlarmBoard m_alarms{m_log, m_clock};
    PerfectMount m_mount;
    StationControl m_control;
    ReportFile m_report{QString()};
    NightDesk m_desk;
    std::uint64_t m_read = 0;  // the last line of the log that was read
    RehearsedNight m_night;
};

}  // namespace

Result<RehearsedNight> rehearse(const RehearsalTask& task, const std::stop_token& stop,
                                const std::function<void(double)>& progress)
{
    Stage stage(task, stop);
    stage.run(kBegin);
    if (const Result<> armed = stage.arm(); !armed) {
        return tl::unexpected(armed.error());
    }
    // Later passes are left out, because their end is outside the rehearsal.
    const schedule::NightPlan plan = stage.schedule().plan;
    if (plan.chosen.empty()) {
        return failure(ErrorCode::NotAvailable, Text::tr("The schedule has no pass within a day."));
    }
    const UtcTime end = plan.chosen.back().ends() + kBetweenIdleLooks;
    while (stage.utc() < end && stage.schedule().armed) {
        if (stop.stop_requested()) {
            return failure(ErrorCode::NotAvailable, Text::tr("The rehearsal was stopped."));
        }
        progress(Seconds(stage.utc() - task.from) / Seconds(end - task.from));
        stage.goOn();
    }
    return stage.night(plan);
}

}  // namespace boresight

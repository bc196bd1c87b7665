// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/night_desk.h"

#include "core/alarms/catalogue.h"
#include "core/base/overloaded.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/control/calibration_source.h"
#include "core/profile/clear_sky.h"
#include "core/targets/target.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace boresight {
namespace {

constexpr Seconds kShowPeriod{1.0};
// The control may end a pass this much earlier than the plan.
constexpr std::chrono::seconds kAboutToSet{2};

const orbit::ElementSet* find(const std::vector<orbit::ElementSet>& satellites, std::int64_t number)
{
    const auto found = std::ranges::find(satellites, number, &orbit::ElementSet::number);
    return found == satellites.end() ? nullptr : &*found;
}

}  // namespace

bool leavesTheMount(const Request& request)
{
    return std::holds_alternative<request::JudgeDirection>(request) ||
           std::holds_alternative<request::AcknowledgeAlarms>(request) ||
           std::holds_alternative<request::AcknowledgeAlarm>(request) ||
           std::holds_alternative<request::SetReadOnly>(request) ||
           std::holds_alternative<request::Disconnect>(request) ||
           std::holds_alternative<request::TakeAuthority>(request) ||
           std::holds_alternative<request::ApplyProfile>(request) ||
           std::holds_alternative<request::UseNewTime>(request) ||
           std::holds_alternative<request::LogProtocol>(request) ||
           std::holds_alternative<request::ReadGains>(request) || std::holds_alternative<request::Rehearse>(request) ||
           std::holds_alternative<ScheduleRequest>(request);
}

const Source& scheduleSource()
{
    static const Source kSource{.kind = SourceKind::Operator,
                                .clientId = std::numeric_limits<std::uint64_t>::max() - 2,
                                .name = QStringLiteral("schedule")};
    return kSource;
}

NightDesk::NightDesk(StationControl& control, const profile::InForce& profile, ReportFile& file, const Clock& clock,
                     EventLog& log, Search search, PassMoments::Tell tell)
    : m_control(control),
      m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_search(std::move(search)),
      m_moments(log, clock, std::move(tell)),
      m_report(file, clock, log, scheduleSource().name)
{
    show();
}

NightDesk::~NightDesk()
{
    const QString why = Text::tr("Boresight was closed");
    if (m_tracked) {
        m_report.store(m_tracked->tally().ended(schedule::PassEnd::Manual, why));
    }
    m_moments.end(schedule::PassEnd::Manual, why);
}

Result<> NightDesk::carryOut(const ScheduleRequest& request, const Source& by)
{
    const Result<> done = std::visit(
        Overloaded{[&](const request::ArmSchedule&) {
                       return arm(by, Severity::Advisory, Text::tr("arms the schedule of passes"));
                   },
                   [&](const request::DisarmSchedule&) -> Result<> {
                       m_policyUsed = true;
                       if (m_armed) {
                           holdNow();
                           disarm({.end = schedule::PassEnd::Manual,
                                   .why = Text::tr("%1 disarmed it").arg(sourceText(by.name))});
                           m_control.alarms().clear(alarmEntry("schedule.disarmed"));  // the operator wanted this
                       }
                       return {};
                   }},
        request);
    show();
    return done;
}

void NightDesk::fill(StationStatus& status) const
{
    status.schedule = m_shown;
    if (const Result<> may = mayArm(); !may) {
        status.permissions.refuse(Action::ArmSchedule, may.error().text);
    }
}

Result<> NightDesk::mayArm() const
{
    if (m_profile->schedule.watch.empty()) {
        return failure(ErrorCode::Refused, Text::tr("The watch list of the profile is empty."));
    }
    if (!m_profile->site.known) {
        return failure(ErrorCode::Refused, Text::tr("The site of the mount is not set. Enter it in the profile."));
    }
    if (m_control.obeys(calibrationSource()) || m_control.obeys(tuningSource())) {
        return failure(ErrorCode::Busy, Text::tr("A calibration or a tuning run moves the mount. End it first."));
    }
    return m_control.mayPoint(scheduleSource());
}

Result<> NightDesk::arm(const Source& by, Severity severity, const QString& words)
{
    if (m_armed) {
        return {};
    }
    return mayArm()
        .and_then([&]() -> Result<> {
            return m_control.authority() == Authority::Clients ? m_control.request(request::TakeAuthority{}, by)
                                                               : Result<>{};
        })
        .map([&] {
            m_policyUsed = true;
            m_armed = true;
            m_why.clear();
            m_motionId = m_control.motionId();
            m_heldBefore = m_control.heldBy().has_value();
            m_handledUntil = {};
            m_control.alarms().clear(alarmEntry("schedule.disarmed"));
            m_log.add(severity, by.name, words);
        });
}

void NightDesk::armByPolicy()
{
    if (!m_policyUsed && m_profile->schedule.unattended == profile::Unattended::On && mayArm()) {
        [[maybe_unused]] const Result<> armed =
            arm(scheduleSource(), Severity::Warning, Text::tr("armed by the profile (schedule.unattended)"));
    }
}

void NightDesk::disarm(const Interruption& by)
{
    m_armed = false;
    m_why = by.why;
    m_report.count(by.end);
    if (m_tracked) {
        m_report.keep(m_tracked->tally().ended(by.end, by.why));
        m_tracked.reset();
    } else {
        m_report.flush();
    }
    m_log.add(Severity::Warning, scheduleSource().name, Text::tr("the schedule is off: %1").arg(by.why));
    m_control.alarms().raise(alarmEntry("schedule.disarmed"), {by.why});
    if (by.end == schedule::PassEnd::Fault) {
        m_moments.fault(by.why);
    }
    m_moments.end(by.end, by.why);
    show();
}

void NightDesk::noticed(const Request& request, const Source& by)
{
    if (std::holds_alternative<request::UseAntenna>(request)) {
        m_searched.reset();  // the new antenna has other limits. The schedule stays armed
        return;
    }
    if (leavesTheMount(request)) {
        return;
    }
    m_policyUsed = true;
    if (m_armed) {
        disarm({.end = schedule::PassEnd::Manual,
                .why = std::holds_alternative<request::Stop>(request)
                           ? Text::tr("STOP of %1").arg(sourceText(by.name))
                           : Text::tr("%1 sent another command").arg(sourceText(by.name))});
    }
}

void NightDesk::setSatellites(const Satellites& satellites)
{
    m_satellites = satellites;
    m_searched.reset();
}

void NightDesk::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.schedule != after.schedule || before.site != after.site || before.limits != after.limits ||
        before.pointing != after.pointing || before.antennas != after.antennas ||
        before.satellites != after.satellites || before.azimuth.geometry != after.azimuth.geometry ||
        before.elevation.geometry != after.elevation.geometry) {
        m_searched.reset();
    }
}

void NightDesk::tick()
{
    noticeClock();
    lookForPasses();
    armByPolicy();
    m_heldBefore = m_heldBefore && m_control.heldBy();
    if (m_armed) {
        waitOutWind();
        if (const auto by = interruption()) {
            disarm(*by);
        } else {
            move();
        }
    }
    if (m_clock.now() - m_shownAt >= kShowPeriod) {
        m_report.noteProblem();
        show();
    }
}

// Interruptions that noticed() is not told of: by a client, a calibration, or the mount itself.
std::optional<NightDesk::Interruption> NightDesk::interruption() const
{
    const auto because = [](schedule::PassEnd end, const QString& why) {
        return std::optional(Interruption{.end = end, .why = why});
    };
    switch (m_control.state()) {
        case StationState::Stopped:
            return because(schedule::PassEnd::Manual, Text::tr("STOP is latched"));
        case StationState::Fault:
            return because(schedule::PassEnd::Fault, Text::tr("a fault ended the motion"));
        case StationState::Disconnected:
            return because(schedule::PassEnd::Fault, Text::tr("the mount does not answer"));
        default:
            break;
    }
    if (m_control.authority() == Authority::Clients) {
        return because(schedule::PassEnd::Manual, Text::tr("control was given to the clients"));
    }
    if (m_control.motionId() != m_motionId) {
        return because(schedule::PassEnd::Manual, Text::tr("another command moved the mount"));
    }
    const std::optional<Source>& heldBy = m_control.heldBy();
    if (heldBy && *heldBy != scheduleSource() && !m_heldBefore) {
        return because(schedule::PassEnd::Manual, Text::tr("%1 sent another command").arg(sourceText(heldBy->name)));
    }
    const bool isOver = m_tracked && m_clock.utc() + kAboutToSet >= m_tracked->ends();
    if (m_tracked && !isOver && !m_control.obeys(scheduleSource())) {
        return because(schedule::PassEnd::Refused,
                       Text::tr("The station ended the tracking. The log shows the reason"));
    }
    return std::nullopt;
}

// In a strong wind the mount parks by the profile. The tracked pass is lost, and the schedule continues with the next
// one.
void NightDesk::waitOutWind()
{
    const QString why = m_control.windObstacle();
    if (why.isEmpty()) {
        return;
    }
    m_motionId = m_control.motionId();
    if (m_tracked && !m_control.obeys(scheduleSource())) {
        m_log.add(Severity::Warning, scheduleSource().name,
                  Text::tr("loses the pass of %1: %2").arg(m_tracked->pass().name, why));
        m_report.keep(m_tracked->tally().ended(schedule::PassEnd::Refused, why));
        m_tracked.reset();
        m_moments.end(schedule::PassEnd::Refused, why);
        show();
    }
}

// After the clock was set back, passes that were over are ahead again. A tracked pass now begins later, after them.
void NightDesk::noticeClock()
{
    const UtcTime utc = m_utc.now(m_clock);
    if (m_utc.jump() >= Seconds(0.0)) {
        return;
    }
    m_log.add(Severity::Warning, scheduleSource().name,
              Text::tr("plans the passes again, because the clock of this computer was set back by %1 s")
                  .arg(-m_utc.jump().count(), 0, 'f', 1));
    m_handledUntil = {};
    m_searched.reset();
    if (m_tracked && m_tracked->pass().begins() - utc > m_profile->schedule.lead) {
        finish(schedule::PassEnd::Refused, Text::tr("the clock of this computer was set back"));
    }
}

// Used for new plans only: a tracked pass stays as it was planned.
std::function<bool(const SkyPointing&)> NightDesk::clearSkyOf(std::int64_t satellite) const
{
    const std::string own = orbit::antennaOf(m_profile->satellites, satellite);
    return profile::clearSky(*m_profile, own.empty() ? m_control.chosenAntenna() : m_profile->antenna(own));
}

void NightDesk::lookForPasses()
{
    const SteadyTime now = m_clock.now();
    if (m_tracked || (m_searched && now - *m_searched < kRenewed)) {
        return;
    }
    m_searched = now;
    std::vector<schedule::WatchedPass> known;
    std::vector<passes::SatelliteSearch> searches;
    QStringList missing;
    const UtcTime utc = m_clock.utc();
    for (const schedule::WatchEntry& entry : m_profile->schedule.watch) {
        const orbit::ElementSet* const set = find(*m_satellites, entry.number);
        if (set == nullptr) {
            missing << QString::number(entry.number);
            continue;
        }
        known.push_back(
            {.number = entry.number, .priority = entry.priority, .name = targets::satelliteName(*set), .pass = {}});
        searches.push_back({.orbit = orbit::Sgp4(*set),
                            .search = {.site = m_profile->site.place(),
                                       .from = utc,
                                       .to = utc + kPlanned,
                                       .minimumElevation = entry.leastElevation,
                                       .isClear = clearSkyOf(entry.number)}});
    }
    m_missing = missing.isEmpty() ? QString() : Text::tr("no elements of %1").arg(missing.join(QStringLiteral(", ")));
    if (!m_profile->site.known) {
        searches.clear();
        known.clear();
        m_missing = Text::tr("the site of the mount is not set");
    }
    m_search(std::move(searches), [this, known, number = ++m_searches](const std::vector<passes::PassList>& found) {
        if (number == m_searches) {
            plan(known, found);
        }
    });
}

void NightDesk::plan(const std::vector<schedule::WatchedPass>& known, const std::vector<passes::PassList>& found)
{
    std::vector<schedule::WatchedPass> candidates;
    for (std::size_t i = 0; i < std::min(known.size(), found.size()); ++i) {
        for (const passes::Pass& pass : found[i].passes) {
            candidates.push_back(known[i]);
            candidates.back().pass = pass;
        }
    }
    m_plan = planNight(std::move(candidates), {.policy = m_profile->schedule.policy, .lead = m_profile->schedule.lead});
    show();
}

const schedule::WatchedPass* NightDesk::next() const
{
    const UtcTime over = std::max(m_clock.utc(), m_handledUntil + schedule::kSamePass);
    const auto found =
        std::ranges::find_if(m_plan.chosen, [&](const schedule::WatchedPass& one) { return one.ends() > over; });
    return found == m_plan.chosen.end() ? nullptr : &*found;
}

void NightDesk::move()
{
    const UtcTime utc = m_clock.utc();
    const Seconds before = m_profile->schedule.hooks.before;
    if (m_tracked) {
        m_moments.follow(m_tracked->pass(), before);
        m_tracked->look({.direction = m_control.direction(), .isOnTarget = m_control.onTarget(StatusReport::kOnTarget)},
                        utc, m_clock.now(),
                        {.beamWidth = m_control.antenna().beamWidth, .refraction = m_profile->orbit.refraction});
        if (utc >= m_tracked->ends() || !m_control.obeys(scheduleSource())) {
            finish(schedule::PassEnd::Set, {});
        } else if (utc >= m_tracked->pass().begins()) {
            m_report.goesOn(m_tracked->tally().record());
        }
        return;
    }
    const schedule::WatchedPass* const pass = next();
    m_moments.expect(pass, before);
    if (pass != nullptr && Seconds(pass->begins() - utc) <= m_profile->schedule.lead) {
        begin(*pass);
    }
}

void NightDesk::begin(const schedule::WatchedPass& pass)
{
    const orbit::ElementSet* const set = find(*m_satellites, pass.number);
    TrackedPass tracked(pass, set != nullptr ? *set : orbit::ElementSet{}, m_profile->site.place(), m_clock.now());
    const Result<> begun =
        set != nullptr ? ask(request::Track{targets::satelliteTarget(*set)})
                       : failure(ErrorCode::NotAvailable, Text::tr("The elements of %1 are gone.").arg(pass.name));
    m_handledUntil = pass.ends();
    if (begun) {
        m_log.add(Severity::Advisory, scheduleSource().name,
                  Text::tr("goes to the pass of %1 at %2").arg(pass.name, timeOfDayText(pass.begins())));
        m_tracked.emplace(std::move(tracked));
        m_report.begun();
    } else {
        m_log.add(Severity::Warning, scheduleSource().name,
                  Text::tr("the pass of %1 is left out: %2").arg(pass.name, begun.error().text));
        m_report.keep(tracked.tally().ended(schedule::PassEnd::Refused, begun.error().text));
        m_moments.end(schedule::PassEnd::Refused, begun.error().text);
    }
    show();
}

void NightDesk::finish(schedule::PassEnd end, const QString& why)
{
    m_report.keep(m_tracked->tally().ended(end, why));
    m_tracked.reset();
    m_moments.end(end, why);
    holdNow();
    restBetween();
    show();
}

// Holds only what the schedule moves. A motion of somebody else, and its control authority, stay unchanged.
void NightDesk::holdNow()
{
    if (m_control.obeys(scheduleSource())) {
        [[maybe_unused]] const Result<> held = ask(request::Hold{});
    }
}

// Sends the mount to where it waits for the next pass, if permitted. If the request is refused, the mount holds.
void NightDesk::restBetween()
{
    const profile::ScheduleSettings& wanted = m_profile->schedule;
    const schedule::WatchedPass* const after = next();
    if (after != nullptr && Seconds(after->begins() - m_clock.utc()) <= wanted.lead) {
        return;  // the mount goes there at once
    }
    const bool isLong = after == nullptr || after->begins() - m_clock.utc() > kLongPause;
    const bool parks =
        wanted.between == profile::BetweenPasses::Park || (isLong && wanted.parkAfter == profile::ParkAfter::On);
    if (parks) {
        [[maybe_unused]] const Result<> parked = ask(request::Park{});
    } else if (wanted.between == profile::BetweenPasses::Unwind) {
        [[maybe_unused]] const Result<> unwound = ask(request::Unwind{});
    }
}

Result<> NightDesk::ask(const Request& request)
{
    const Result<> answer = m_control.request(request, scheduleSource());
    m_motionId = m_control.motionId();
    return answer;
}

void NightDesk::show()
{
    m_shownAt = m_clock.now();
    ScheduleStatus status{
        .armed = m_armed, .why = m_armed ? QString() : m_why, .plan = m_plan, .report = m_report.report()};
    if (!m_missing.isEmpty()) {
        status.why += (status.why.isEmpty() ? QString() : QStringLiteral("; ")) + m_missing;
    }
    if (m_tracked) {
        status.tracked = m_tracked->pass().number;
        status.report.passes.push_back(m_tracked->tally().record());
    }
    m_shown = std::make_shared<const ScheduleStatus>(std::move(status));
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_desk.h"

#include "core/base/overloaded.h"
#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/tuning/tuning_judge.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

const QString kTuningLog = QStringLiteral("tuning");
constexpr Seconds kRenewal{1.0};
constexpr Seconds kRenewalInRun{0.2};

QString titleOf(TuningRun run, Axis axis)
{
    const bool azimuth = axis == Axis::Azimuth;
    switch (run) {
        case TuningRun::Step:
            return azimuth ? Text::tr("step of the azimuth") : Text::tr("step of the elevation");
        case TuningRun::Ramp:
            return azimuth ? Text::tr("ramp of the azimuth") : Text::tr("ramp of the elevation");
        case TuningRun::Sweep:
            return azimuth ? Text::tr("small swings of the azimuth") : Text::tr("small swings of the elevation");
        case TuningRun::Backlash:
            break;
    }
    return azimuth ? Text::tr("backlash of the azimuth") : Text::tr("backlash of the elevation");
}

QString whoEndedIt(const StationControl& control)
{
    switch (control.state()) {
        case StationState::Stopped:
            return Text::tr("STOP ended the run. There is no result.");
        case StationState::Fault:
        case StationState::Disconnected:
            return Text::tr("A fault ended the run. There is no result.");
        default:
            return Text::tr("Another command to the mount ended the run. There is no result.");
    }
}

// True if the gains were not changed since they were read first. A value that was not read counts as unchanged.
bool areAsFound(const DriveGains& gains)
{
    return std::ranges::all_of(gains.lines,
                               [](const GainLine& line) { return !line.value || isSameGain(line.value, line.first); });
}

}  // namespace

TuningDesk::TuningDesk(StationControl& control, const Clock& clock, EventLog& log)
    : m_control(control), m_clock(clock), m_log(log), m_shown(std::make_shared<const TuningStatus>())
{}

Result<> TuningDesk::carryOut(const TuningRequest& request, const std::optional<DrivesStatus>& drives, bool calibrates)
{
    const Result<> done =
        std::visit(Overloaded{[&](const request::StartTuning& wanted) { return start(wanted, drives, calibrates); },
                              [&](const request::EndTuning&) -> Result<> {
                                  if (!m_run) {
                                      return failure(ErrorCode::Refused, Text::tr("No tuning run is active."));
                                  }
                                  end(Text::tr("The operator ended the run. There is no result."), true);
                                  return {};
                              }},
                   request);
    renew();
    return done;
}

Result<> TuningDesk::mayStart(Axis axis, bool calibrates) const
{
    if (m_run) {
        return failure(ErrorCode::Busy, Text::tr("A tuning run moves the mount. End it first."));
    }
    if (calibrates) {
        return failure(ErrorCode::Busy, Text::tr("A calibration moves the mount. End it first."));
    }
    if (!m_control.mount().capabilities().has(axis)) {
        return failure(ErrorCode::NotAvailable, Text::tr("This mount has no such axis."));
    }
    return m_control.mayPoint(tuningSource())
        .and_then([this]() -> Result<> {
            return m_control.authority() == Authority::Clients
                       ? failure(ErrorCode::Refused,
                                 Text::tr("The clients have control. Take control before you tune an axis."))
                       : Result<>{};
        })
        .and_then([this] { return m_control.measured().map([](const AxisPosition&) {}); })
        .and_then([this]() -> Result<> {
            const auto moves = [this](Axis one) { return m_control.isSeenToMove(one); };
            return std::ranges::any_of(kAxes, moves)
                       ? failure(ErrorCode::Refused, Text::tr("The mount moves. Stop it first."))
                       : Result<>{};
        });
}

TuningWay TuningDesk::way(TuningRun run, Axis axis) const
{
    const auto here = m_control.measured();
    if (!here) {
        return {.plan = {.obstacle = here.error().text}};
    }
    return planTuning(run, axis, *here, m_control.region(), m_control.limits(axis));
}

Result<> TuningDesk::start(const request::StartTuning& wanted, const std::optional<DrivesStatus>& drives,
                           bool calibrates)
{
    if (const Result<> may = mayStart(wanted.axis, calibrates); !may) {
        return may;
    }
    TuningWay found = way(wanted.run, wanted.axis);
    if (!found.plan.obstacle.isEmpty()) {
        return failure(ErrorCode::Refused, found.plan.obstacle);
    }
    m_gains.clear();
    m_asFound = true;
    if (drives) {
        const DriveGains& gains = (wanted.axis == Axis::Azimuth ? drives->azimuth : drives->elevation).gains;
        std::ranges::transform(gains.lines, std::back_inserter(m_gains), &GainLine::value);
        m_asFound = areAsFound(gains);
    }
    m_log.add(Severity::Advisory, kTuningLog,
              QStringLiteral("%1: %2").arg(titleOf(wanted.run, wanted.axis), found.plan.text));
    m_begun = false;
    m_run.emplace(wanted.run, wanted.axis, std::move(found), *m_control.measured(), m_clock.now());
    return {};
}

void TuningDesk::tick()
{
    if (const auto sample = m_control.sample(); m_run && sample) {
        if (const QString why = ending(); !why.isEmpty()) {
            end(why, true);
        } else {
            move(*sample);
        }
    }
    if (m_clock.now() - m_renewed >= (m_run ? kRenewalInRun : kRenewal)) {
        renew();
    }
}

QString TuningDesk::ending() const
{
    if (m_begun && !m_control.obeys(tuningSource())) {
        return whoEndedIt(m_control);
    }
    if (const QString obstacle = m_run->obstacle(m_clock.now()); !obstacle.isEmpty()) {
        return obstacle + QStringLiteral(". ") + Text::tr("There is no result.");
    }
    return {};
}

void TuningDesk::move(const TickSample& sample)
{
    const auto wanted = m_run->step(m_clock.now(), sample.axes[index(m_run->axis())]);
    if (m_run->done()) {
        finish();
        return;
    }
    if (!wanted) {
        return;
    }
    const Result<> moved = m_control.request(*wanted, tuningSource());
    if (!moved) {
        end(moved.error().text, true);
    }
    m_begun = true;
}

void TuningDesk::finish()
{
    auto result = resultOf(*m_run);
    if (!result) {
        end(result.error().text, true);
        return;
    }
    result->when = m_clock.utc();
    result->gains = m_gains;
    result->asFound = m_asFound;
    const QString words = result->verdict.join(QLatin1Char(' '));
    keep(std::move(*result));
    end(words, false);
}

// Keeps the newest result of its kind. A result with changed gains is kept beside the one with the gains as found.
void TuningDesk::keep(TuningResult result)
{
    std::erase_if(m_status.results, [&](const TuningResult& one) {
        return one.axis == result.axis && one.run == result.run && one.asFound == result.asFound;
    });
    m_status.results.push_back(std::move(result));
}

void TuningDesk::end(const QString& outcome, bool failed)
{
    const QString title = titleOf(m_run->run(), m_run->axis());
    m_status.outcome = {.axis = m_run->axis(), .run = m_run->run(), .text = outcome, .failed = failed};
    m_run.reset();
    hold();
    m_log.add(failed ? Severity::Warning : Severity::Advisory, kTuningLog,
              QStringLiteral("%1: %2").arg(title, outcome));
    renew();
}

void TuningDesk::hold()
{
    if (m_control.obeys(tuningSource())) {
        [[maybe_unused]] const Result<> held = m_control.request(request::Hold{}, tuningSource());
    }
}

void TuningDesk::renew()
{
    m_renewed = m_clock.now();
    m_status.running = m_run ? std::optional(m_run->run()) : std::nullopt;
    if (m_run) {
        m_status.axis = m_run->axis();
        m_status.done = m_run->part(m_renewed);
        m_status.left = m_run->left(m_renewed);
    } else {
        for (const Axis axis : kAxes) {
            for (std::size_t i = 0; i < kTuningRuns.size(); ++i) {
                m_status.plans[index(axis)][i] = way(kTuningRuns[i], axis).plan;
            }
        }
    }
    m_shown = std::make_shared<const TuningStatus>(m_status);
}

void TuningDesk::fill(StationStatus& status, bool calibrates) const
{
    status.tuning = m_shown;
    Permissions& may = status.permissions;
    for (const Axis axis : kAxes) {
        const Result<> start = mayStart(axis, calibrates);
        may.refuse(actionOf(Action::TuneAzimuth, axis), start ? QString() : start.error().text);
    }
    may.refuse(Action::EndTuning, m_run ? QString() : Text::tr("No tuning run is active."));
    const bool inMotion = status.state == StationState::Hold || status.state == StationState::Slew;
    if (m_run && m_begun && inMotion) {
        status.state = StationState::Calibrate;
        status.targetText = titleOf(m_run->run(), m_run->axis());
    }
}

}  // namespace boresight

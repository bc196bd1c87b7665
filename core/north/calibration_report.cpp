// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk that tells the screen what it does and knows.
#include "core/base/text.h"
#include "core/north/calibration_desk.h"
#include "core/witness/sensor_curve.h"

#include <algorithm>

namespace boresight {
namespace {

QString reasonOf(const Result<>& result)
{
    return result ? QString() : toQString(result.error().text);
}

QString placeText(calibration::MountDifference difference)
{
    switch (difference) {
        case calibration::MountDifference::OtherSite:
            return Text::tr("at another site");
        case calibration::MountDifference::OtherDrive:
            return Text::tr("with another drive");
        case calibration::MountDifference::None:
            break;
    }
    return {};
}

}  // namespace

void CalibrationDesk::publish()
{
    m_published = m_clock.now();
    m_alarms.update();
    m_proposals.dropStale();
    watchPoints();
    m_changed = false;
    CalibrationStatus status{.progress = m_runs.progress(),
                             .present = m_profile.pointing,
                             .sheet = m_model.sheet(),
                             .otherMount = m_model.otherMount(),
                             .sensorOffset = m_proposals.sensorOffset(),
                             .sensorObstacle = reasonOf(m_sensor.isUsable()),
                             .swingPlan = m_runs.swingPlan(),
                             .swingSoFar = m_runs.swingSoFar(),
                             .swing = m_proposals.swing()};
    fillBodies(status);
    status.pointObstacle = reasonOf(m_taker.mayTakeBody());
    status.points = m_points.book().status();
    status.fit = m_points.book().fitStatus(m_profile.pointing);
    status.noFit = m_points.book().problem();
    status.scan = m_runs.scan().scanned();
    status.power = m_runs.scan().power();
    status.powerLine = m_runs.scan().line();
    status.wantsPower = m_runs.wantsPower();
    status.proposal = proposalStatus();
    status.history = historyStatus();
    status.historyProblem = m_file.problem();
    status.canUndo = m_file.history().canUndo();
    status.canRedo = m_file.history().canRedo();
    m_status = std::make_shared<const CalibrationStatus>(std::move(status));
}

void CalibrationDesk::fill(StationStatus& status) const
{
    status.calibration = m_status;
    const bool inMotion = status.state == StationState::Hold || status.state == StationState::Slew ||
                          status.state == StationState::Jog || status.state == StationState::Track;
    if (moves() && inMotion) {
        status.state = StationState::Calibrate;
        if (m_runs.swing().run()) {
            status.targetText = Text::tr("compass swing");
        }
    }
}

void CalibrationDesk::fillBodies(CalibrationStatus& status)
{
    status.refraction = m_follower.refraction();
    status.body = m_follower.body();
    status.following = m_follower.following();
    status.overTheTop = m_follower.overTheTop();
    if (const auto known = m_follower.direction(ephemeris::Body::Sun); !known) {
        status.noSite = toQString(known.error().text);
        return;
    }
    m_follower.lookAhead();
    for (const ephemeris::Body body : kBodies) {
        status.bodies.push_back(m_follower.now(body));
    }
    if (m_alarms.isAtSun()) {
        status.warning = Text::tr(
            "The beam looks into the Sun: nobody looks along it, nor through a sight tube "
            "without a solar filter; mind the heat in the feed");
    }
}

std::optional<CalibrationProposal> CalibrationDesk::proposalStatus() const
{
    const std::optional<Proposal>& proposal = m_proposals.current();
    if (!proposal) {
        return std::nullopt;
    }
    CalibrationProposal told{.number = proposal->number,
                             .title = proposal->title,
                             .reason = proposal->reason,
                             .text = proposal->text,
                             .terms = termsBeside(m_profile.pointing, proposal->terms),
                             .residuals = m_points.book().residuals(proposal->terms),
                             .changesSensor = proposal->sensor.has_value(),
                             .warnings = proposal->warnings,
                             .obstacle = reasonOf(m_changes.mayChange())};
    const calibration::TermSheet present = m_model.sheet();
    for (const calibration::Term term : calibration::kAllTerms) {
        TermStatus& one = told.terms[calibration::indexOf(term)];
        one.sigma = proposal->sigmas[calibration::indexOf(term)];
        one.isOn = m_proposals.isFound(term);
        if (!one.sigma && one.proposed == one.present) {
            one.sigma = present.sigmas[calibration::indexOf(term)];  // what stays is known as well as before
        }
    }
    return told;
}

// Newest first; what was superseded stands where it was applied, whatever the clock did to the others.
std::vector<CalibrationHistoryEntry> CalibrationDesk::historyStatus() const
{
    std::vector<CalibrationHistoryEntry> list;
    const calibration::CalibrationHistory& history = m_file.history();
    const calibration::RecordMount today = m_mount.today();
    const auto told = [&](const calibration::CalibrationRecord& record) {
        const calibration::MountDifference difference = calibration::difference(record.mount, today);
        return CalibrationHistoryEntry{
            .when = record.when,
            .title = toQString(record.title),
            .change = changeText(record.terms.before, record.terms.after, record.sensor.has_value()),
            .place = placeText(difference),
            .otherMount = difference != calibration::MountDifference::None};
    };
    for (std::size_t i = 0; i < history.entries().size(); ++i) {
        list.push_back(told(history.entries()[i]));
        list.back().inForce = i < history.inForce();
    }
    if (const QString since = m_model.changedSince(); !since.isEmpty()) {
        CalibrationHistoryEntry& last = list[history.inForce() - 1];
        last.title = Text::tr("%1, changed by hand since").arg(last.title);
        last.change = Text::tr("%1; since then by hand: %2").arg(last.change, since);
    }
    for (const calibration::CalibrationRecord& record : history.superseded()) {
        const auto later = std::ranges::find_if(list, [&](const auto& entry) { return entry.when > record.when; });
        list.insert(later, told(record))->superseded = true;
    }
    std::ranges::reverse(list);
    return list;
}

}  // namespace boresight

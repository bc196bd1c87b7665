// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_report.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr std::chrono::milliseconds kPeriod{250};

QString reasonOf(const Result<>& result)
{
    return result ? QString() : result.error().text;
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

bool CalibrationReport::isDue() const
{
    return m_expired || m_clock.now() - m_made >= kPeriod;
}

void CalibrationReport::renew()
{
    m_made = m_clock.now();
    m_expired = false;
    const calibration::CalibrationHistory& history = m_of.file.history();
    CalibrationStatus status{.progress = m_of.runs.progress(),
                             .present = m_of.profile->pointing,
                             .sheet = m_of.model.sheet(),
                             .otherMount = m_of.model.otherMount(),
                             .sensorOffset = m_of.proposals.sensorOffset(),
                             .sensorObstacle = reasonOf(m_of.sensor.isUsable()),
                             .averageObstacle = reasonOf(m_of.runs.mayAverage()),
                             .swingPlan = m_of.runs.swingPlan(),
                             .swingSoFar = m_of.runs.swingSoFar(),
                             .swing = m_of.proposals.swing()};
    fillBodies(status);
    fillPoints(status);
    status.proposal = proposalStatus();
    status.history = historyEntries();
    status.historyProblem = m_of.file.problem();
    status.canUndo = history.canUndo();
    status.canRedo = history.canRedo();
    status.undoObstacle = reasonOf(m_of.changes.mayUndo());
    status.redoObstacle = reasonOf(m_of.changes.mayRedo());
    m_status = std::make_shared<const CalibrationStatus>(std::move(status));
}

void CalibrationReport::fillPoints(CalibrationStatus& status) const
{
    const PointBook& book = m_of.points.book();
    const ScanPilot& scan = m_of.runs.scan();
    status.pointObstacle = reasonOf(m_of.taker.mayTakeBody());
    status.knownPointObstacle = reasonOf(m_of.taker.mayTake());
    status.noRoom = reasonOf(m_of.points.hasRoom());
    status.points = book.status();
    status.fit = book.fitStatus(m_of.profile->pointing);
    status.noFit = book.problem();
    status.scan = scan.scanned();
    status.power = scan.power();
    status.powerLine = scan.line();
    status.wantsPower = m_of.runs.wantsPower();
}

void CalibrationReport::fillBodies(CalibrationStatus& status) const
{
    status.refraction = m_of.follower.refraction();
    status.body = m_of.follower.body();
    status.following = m_of.follower.following();
    status.overTheTop = m_of.follower.overTheTop();
    if (const auto known = m_of.follower.direction(ephemeris::Body::Sun); !known) {
        status.noSite = known.error().text;
        return;
    }
    m_of.follower.lookAhead();
    for (const ephemeris::Body body : kBodies) {
        status.bodies.push_back(m_of.follower.now(body));
    }
    if (m_of.alarms.isAtSun()) {
        status.warning = Text::tr(
            "The antenna points at the Sun. Never look along the beam or a sight tube without a solar filter. Watch "
            "the heat at the feed");
    }
}

std::optional<CalibrationProposal> CalibrationReport::proposalStatus() const
{
    const std::optional<Proposal>& proposal = m_of.proposals.current();
    if (!proposal) {
        return std::nullopt;
    }
    CalibrationProposal told{.number = proposal->number,
                             .title = proposal->title,
                             .reason = proposal->reason,
                             .text = proposal->text,
                             .remark = proposal->remark,
                             .terms = termsBeside(m_of.profile->pointing, proposal->terms),
                             .residuals = m_of.points.book().residuals(proposal->terms),
                             .changesSensor = proposal->sensor.has_value(),
                             .doubts = proposal->doubts,
                             .warnings = proposal->warnings,
                             .obstacle = reasonOf(m_of.changes.mayChange())};
    const calibration::TermSheet present = m_of.model.sheet();
    for (const calibration::Term term : calibration::kAllTerms) {
        TermStatus& one = told.terms[calibration::indexOf(term)];
        one.sigma = proposal->sigmas[calibration::indexOf(term)];
        one.isOn = m_of.proposals.isFound(term);
        if (!one.sigma && one.proposed == one.present) {
            one.sigma = present.sigmas[calibration::indexOf(term)];  // a term that stays keeps its sigma
        }
    }
    return told;
}

// Newest first. An entry that was superseded stays where it was applied, even if the clock was changed since.
std::vector<CalibrationHistoryEntry> CalibrationReport::historyEntries() const
{
    std::vector<CalibrationHistoryEntry> list;
    const calibration::CalibrationHistory& history = m_of.file.history();
    const calibration::RecordMount today = m_of.mount.today();
    const auto told = [&](const calibration::CalibrationRecord& record) {
        const calibration::MountDifference difference = calibration::difference(record.mount, today);
        return CalibrationHistoryEntry{
            .when = record.when,
            .title = record.title,
            .change = changeText(record.terms.before, record.terms.after, record.sensor.has_value()),
            .place = placeText(difference),
            .otherMount = difference != calibration::MountDifference::None};
    };
    for (std::size_t i = 0; i < history.entries().size(); ++i) {
        list.push_back(told(history.entries()[i]));
        list.back().inForce = i < history.inForce();
    }
    if (const QString since = m_of.model.changedSince(); !since.isEmpty()) {
        CalibrationHistoryEntry& last = list[history.inForce() - 1];
        last.title = Text::tr("%1, changed by hand since").arg(last.title);
        last.change = Text::tr("%1. Changed by hand after that: %2").arg(last.change, since);
    }
    for (const calibration::CalibrationRecord& record : history.superseded()) {
        const auto later = std::ranges::find_if(list, [&](const auto& entry) { return entry.when > record.when; });
        list.insert(later, told(record))->superseded = true;
    }
    std::ranges::reverse(list);
    return list;
}

}  // namespace boresight

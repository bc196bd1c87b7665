// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk that tells the screen what it does and knows.
#include "core/base/text.h"
#include "core/station/calibration_desk.h"

namespace boresight {
namespace {

const QString kFileCause = QStringLiteral("calibrations");

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
    warnOfOtherMount();
    warnOfFile();
    dropStale();
    noteTurns();
    m_changed = false;
    CalibrationStatus status{.progress = progress(),
                             .present = m_profile.pointing,
                             .sheet = sheet(),
                             .otherMount = otherMount(),
                             .sensorOffset = m_sensorOffset,
                             .sensorObstacle = reasonOf(sensorTells()),
                             .swingPlan = planned(m_swingWish),
                             .swing = m_swung};
    if (const auto may = maySwing(); !may) {
        status.swingPlan.obstacle = toQString(may.error().text);
    }
    fillBodies(status);
    status.pointObstacle = reasonOf(mayTakeBody());
    status.points = m_book.status();
    status.fit = m_book.fitStatus(m_profile.pointing);
    status.scan = m_scanned;
    status.power = m_power;
    status.powerLine = m_powerLine;
    status.wantsPower = m_scan && m_scan->wantsPower(m_clock.now());
    status.proposal = proposalStatus();
    status.history = historyStatus();
    status.historyProblem = m_file.problem();
    status.canUndo = m_file.history().canUndo();
    status.canRedo = m_file.history().canRedo();
    m_status = std::make_shared<const CalibrationStatus>(std::move(status));
}

void CalibrationDesk::warnOfFile()
{
    if (m_file.problem().isEmpty()) {
        m_control.alarms().clear(kFileCause);
        return;
    }
    m_control.alarms().raise(
        kFileCause, Severity::Warning,
        {.what = m_file.problem(),
         .action = Text::tr("What is applied is in force; its history is kept in memory only"),
         .remedy = Text::tr("Check the disk, or choose another folder with --state-dir; else it cannot be taken back "
                            "after the program was ended")});
}

void CalibrationDesk::fill(StationStatus& status) const
{
    status.calibration = m_status;
    const bool inMotion = status.state == StationState::Hold || status.state == StationState::Slew ||
                          status.state == StationState::Jog || status.state == StationState::Track;
    if (moves() && inMotion) {
        status.state = StationState::Calibrate;
    }
}

CalibrationProgress CalibrationDesk::progress() const
{
    const SteadyTime now = m_clock.now();
    CalibrationProgress progress{.run = run(), .outcome = m_outcome, .failed = m_failed};
    if (m_swing) {
        progress.done = m_swing->part(now);
        progress.left = m_swing->left(now);
        progress.text = m_swing->text(now);
    } else if (m_scan) {
        progress.done = m_scan->part();
        progress.text = m_scan->text(now);
    } else if (m_offsetRun) {
        const Seconds passed(now - m_offsetRun->started);
        progress.done = std::min(passed / kOffsetTime, 1.0);
        progress.left = std::max(kOffsetTime - passed, Seconds(0.0));
        progress.text = Text::tr("readings: %1").arg(m_offsetRun->readings.size());
    }
    return progress;
}

void CalibrationDesk::fillBodies(CalibrationStatus& status)
{
    status.refraction = m_follower.refraction();
    status.body = m_follower.body();
    status.following = m_follower.following();
    if (const auto known = m_follower.direction(ephemeris::Body::Sun); !known) {
        status.noSite = toQString(known.error().text);
        return;
    }
    m_follower.lookAhead();
    for (const ephemeris::Body body : kBodies) {
        status.bodies.push_back(m_follower.now(body));
    }
    if (status.following && status.body == ephemeris::Body::Sun) {
        status.warning = Text::tr(
            "The beam looks into the Sun: nobody looks along it, nor through a sight tube "
            "without a solar filter; mind the heat in the feed");
    }
}

std::optional<CalibrationProposal> CalibrationDesk::proposalStatus() const
{
    if (!m_proposal) {
        return std::nullopt;
    }
    CalibrationProposal told{.number = m_proposal->number,
                             .title = m_proposal->title,
                             .reason = m_proposal->reason,
                             .text = m_proposal->text,
                             .terms = termsBeside(m_profile.pointing, m_proposal->terms),
                             .residuals = m_book.residuals(m_proposal->terms),
                             .changesSensor = m_proposal->sensor.has_value(),
                             .warnings = m_proposal->warnings,
                             .obstacle = reasonOf(mayChange())};
    for (const calibration::Term term : calibration::kAllTerms) {
        const auto& sigma = m_proposal->sigmas[calibration::indexOf(term)];
        TermStatus& one = told.terms[calibration::indexOf(term)];
        one.sigma = sigma;
        one.isOn = sigma.has_value() || (m_by == ProposedBy::Given && one.proposed != one.present);
    }
    return told;
}

std::vector<CalibrationHistoryEntry> CalibrationDesk::historyStatus() const
{
    std::vector<CalibrationHistoryEntry> list;
    const auto& entries = m_file.history().entries();
    const calibration::RecordMount today = mountToday();
    for (std::size_t i = entries.size(); i > 0; --i) {
        const calibration::CalibrationRecord& record = entries[i - 1];
        const calibration::MountDifference difference = calibration::difference(record.mount, today);
        list.push_back({.when = record.when,
                        .title = toQString(record.title),
                        .change = changeText(record.terms.before, record.terms.after),
                        .place = placeText(difference),
                        .inForce = i <= m_file.history().inForce(),
                        .otherMount = difference != calibration::MountDifference::None});
    }
    return list;
}

}  // namespace boresight

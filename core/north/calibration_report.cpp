// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk that tells the screen what it does and knows.
#include "core/base/text.h"
#include "core/north/calibration_desk.h"
#include "core/units/angle_between.h"
#include "core/witness/sensor_curve.h"

#include <algorithm>

namespace boresight {
namespace {

const QString kFileCause = QStringLiteral("calibrations");
// A beam that is sharper than this gathers the Sun's light in the feed, or beside it.
constexpr Angle kNearSun = Angle::fromDegrees(1.0);
// The alarm must not come and go with the noise of an encoder.
constexpr Angle kClearOfSun = Angle::fromDegrees(0.05);

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
    warnOfSun();
    dropStale();
    leaveOutOtherPoints();
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
    if (m_swing) {
        status.swingSoFar = m_swing->dots(mountingOf(m_profile.sensor).sense);
    }
    if (const auto may = maySwing(); !may) {
        status.swingPlan.obstacle = toQString(may.error().text);
    }
    fillBodies(status);
    status.pointObstacle = reasonOf(mayTakeBody());
    status.knownPointObstacle = reasonOf(mayTakePoint());
    status.points = m_book.status();
    status.fit = m_book.fitStatus(m_profile.pointing);
    status.noFit = m_book.problem();
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

// Led there, or standing there whoever has led it; what only passes by is not told.
bool CalibrationDesk::beamAtSun()
{
    if (m_follower.follows(ephemeris::Body::Sun)) {
        return true;
    }
    const auto sun = m_follower.direction(ephemeris::Body::Sun);
    if (!sun || sun->elevation < Angle{} || m_profile.sun.keepAway == profile::KeepAway::On) {
        return false;  // its keep-out has an alarm of its own
    }
    const bool told = m_control.alarms().active(kAtSun);
    const auto beam = m_control.direction();
    if (!beam) {
        return told;  // and nothing else is known
    }
    const Angle distance = angleBetween(*beam, *sun);
    const Angle near = std::max(m_profile.mount.beamWidth / 2.0, kNearSun);
    return told ? distance < near + kClearOfSun : distance < near && stands();
}

void CalibrationDesk::warnOfSun()
{
    if (!beamAtSun()) {
        m_control.alarms().clear(kAtSun);
        return;
    }
    m_control.alarms().raise(
        kAtSun, Severity::Warning,
        {.what = Text::tr("the beam is at the Sun, or led there"),
         .action = m_follower.follows(ephemeris::Body::Sun)
                       ? Text::tr("The mount follows the Sun until something else is asked of it")
                       : Text::tr("That lasts until the mount is moved or the Sun has passed"),
         .remedy = Text::tr("Never look along the beam, nor through a sight tube without a solar filter; a dish "
                            "gathers the Sun's heat in the feed: cover it, or be quick")});
}

void CalibrationDesk::fill(StationStatus& status) const
{
    status.calibration = m_status;
    const bool inMotion = status.state == StationState::Hold || status.state == StationState::Slew ||
                          status.state == StationState::Jog || status.state == StationState::Track;
    if (moves() && inMotion) {
        status.state = StationState::Calibrate;
        if (m_swing) {
            status.targetText = Text::tr("compass swing");
        }
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
    status.overTheTop = m_follower.overTheTop();
    if (const auto known = m_follower.direction(ephemeris::Body::Sun); !known) {
        status.noSite = toQString(known.error().text);
        return;
    }
    m_follower.lookAhead();
    for (const ephemeris::Body body : kBodies) {
        status.bodies.push_back(m_follower.now(body));
    }
    if (m_control.alarms().active(kAtSun)) {
        status.warning = Text::tr(
            "The beam looks into the Sun: nobody looks along it, nor through a sight tube "
            "without a solar filter; mind the heat in the feed");
    }
}

// A term that the points only move within what was known of it is held, not told.
bool CalibrationDesk::isTold(calibration::Term term) const
{
    switch (m_by) {
        case ProposedBy::Points:
            return m_book.fitted() && m_book.fitted()->of(term).state == calibration::TermState::Fitted;
        case ProposedBy::Given:
            return calibration::valueOf(m_proposal->terms, term) != calibration::valueOf(m_profile.pointing, term);
        default:
            return m_proposal->sigmas[calibration::indexOf(term)].has_value();
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
    const calibration::TermSheet present = sheet();
    for (const calibration::Term term : calibration::kAllTerms) {
        TermStatus& one = told.terms[calibration::indexOf(term)];
        one.sigma = m_proposal->sigmas[calibration::indexOf(term)];
        one.isOn = isTold(term);
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
    const calibration::RecordMount today = mountToday();
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
    if (const QString since = changedSince(); !since.isEmpty()) {
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

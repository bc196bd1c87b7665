// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/turn_keeper.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/journal/places.h"
#include "core/journal/power_proof.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// A moving axis is recorded no more often than this. A crash-safe write takes some milliseconds on a disk.
constexpr std::chrono::seconds kMovingPeriod{1};
// For a standing axis only changes are recorded, and the time at this interval: a younger record is the better proof.
constexpr std::chrono::minutes kRestingPeriod{5};
constexpr Angle kWrap = Angle::fromDegrees(360.0);
constexpr Angle kTightens = Angle::fromDegrees(20.0);  // a cable, before its end
constexpr Angle kWorthNoting = Angle::fromDegrees(0.1);
// An eye at the mast estimates an angle this well.
constexpr Angle kEyeSight = Angle::fromDegrees(20.0);
// The millisecond counter of the drive starts again at 0 after this time.
constexpr Seconds kCounterSpan{4294967.296};
// The facts about the drive may be from before its restart. The heartbeat of the drive check detects a restart within a
// second.
constexpr std::chrono::milliseconds kHeartbeat{1500};
// Each reading takes half a dozen frames.
constexpr std::chrono::seconds kOriginPeriod{5};
// The largest error between this computer's clock and the clock of the person who looked.
constexpr std::chrono::minutes kClockError{1};
// Used if there are no candidates, which otherwise give the period.
constexpr Angle kLoneTolerance = Angle::fromDegrees(1.0);

Angle nearestOf(const std::vector<Angle>& candidates, Angle angle)
{
    return *std::ranges::min_element(candidates, {}, [angle](Angle one) { return abs(one - angle).radians(); });
}

// True for a position beyond the bounds of the drive, which may lie at half their margin (drive_check/protections.cpp).
// A drive that is on and is set to such a position pulls the axis to the nearer bound without a ramp, or lets the axis
// go with a fault.
bool beyondBounds(Angle place, const TravelRange& travel, const profile::Profile& profile)
{
    const Angle margin = profile.control.driveLimitMargin * 0.5;
    return place < travel.min - margin || place > travel.max + margin;
}

// The candidate that equals `angle` apart from the noise of a report. Empty if that candidate is not within the travel.
std::optional<Angle> sameAmong(const std::vector<Angle>& candidates, Angle angle, Angle period)
{
    if (candidates.empty()) {
        return std::nullopt;
    }
    const Angle same = nearestOf(candidates, angle);
    return abs(same - angle) < period * 0.25 ? std::optional(same) : std::nullopt;
}

}  // namespace

TurnKeeper::TurnKeeper(const profile::InForce& profile, const Clock& clock, EventLog& log, Start start)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_start(std::move(start)),
      m_placeUsedBefore(m_start.journal.placeUsed && m_start.looked <= *m_start.journal.placeUsed)
{}

std::optional<journal::TurnRecord>& TurnKeeper::record(Axis axis)
{
    return m_start.journal.turns[index(axis)];
}

void TurnKeeper::forget(Axis axis, const std::optional<QString>& doubt)
{
    State& mine = state(axis);
    mine = {
        .doubt = doubt ? doubt : mine.doubt, .since = m_clock.now(), .entered = doubt ? std::nullopt : mine.entered};
    if (doubt && axis == Axis::Azimuth) {
        m_anchor.reset();  // the axis was perhaps not there any more
    }
    if (auto& last = record(axis); doubt && last) {
        last->proveNothing();  // for good. The record still shows where the axis may be
        m_changed = true;
    }
}

bool TurnKeeper::isFresh(Axis axis, const drive_check::DriveFacts& facts) const
{
    return facts.origin.asked > state(axis).since;
}

bool TurnKeeper::needsOrigin(Axis axis, const drive_check::DriveFacts& facts) const
{
    const Phase phase = state(axis).phase;
    const bool old =
        !isFresh(axis, facts) || state(axis).other.origin || m_clock.now() - facts.origin.asked >= kOriginPeriod;
    return (phase == Phase::Unjudged || phase == Phase::Known) && old;
}

// Only the origin shows a small step of the reported position, or a step while this computer stood still. A single
// reading can be false, so a second one must report the same.
void TurnKeeper::watchOrigin(Axis axis, const drive_check::DriveFacts& facts)
{
    State& mine = state(axis);
    const drive_check::OriginReading& read = facts.origin;
    if (!read.origin || !isFresh(axis, facts)) {
        return;
    }
    if (!mine.origin || isSameOrigin(axis, facts, *mine.origin)) {
        mine.origin = mine.origin ? mine.origin : read.origin;
        mine.other = {};
    } else if (read.asked != mine.other.asked && mine.other.origin && isSameOrigin(axis, facts, *mine.other.origin)) {
        forget(axis, Text::tr("The drive's position was set by another tool"));
    } else {
        mine.other = read;
    }
}

bool TurnKeeper::isSameOrigin(Axis axis, const drive_check::DriveFacts& facts, const moteus::CountOrigin& one) const
{
    return journal::isSameOrigin(one, *facts.origin.origin, period(axis, facts), m_profile->axis(axis).geometry);
}

Angle TurnKeeper::period(Axis axis, const drive_check::DriveFacts& facts) const
{
    return journal::ambiguity(m_profile->axis(axis).geometry, facts.rotorToOutputRatio, facts.outputEncoder);
}

// The boards are interchanged: the journal of one axis is no evidence for the other.
bool TurnKeeper::ofTheOtherAxis(Axis axis, const drive_check::DriveFacts& facts) const
{
    const auto& other = m_start.journal.turns[1 - index(axis)];
    return other && other->drive == facts.uuid;
}

void TurnKeeper::judge(Axis axis, const drive_check::DriveFacts& facts, Drive& drive, SteadyTime now)
{
    State& mine = state(axis);
    if (!drive.report() || !drive.place() || !drive.answering(now) || ofTheOtherAxis(axis, facts)) {
        return;
    }
    switch (mine.phase) {
        case Phase::Unjudged:
            if (drive.canBeReferenced() && now >= mine.notBefore && isFresh(axis, facts)) {
                judgeAnew(axis, facts, drive, now);
            }
            break;
        case Phase::Asked:
            watchJog(axis, drive);
            break;
        case Phase::Writing:
            if (drive.takeReferenced()) {
                becomeKnown(axis, drive);
            } else if (drive.phase() != Drive::Phase::Referencing) {
                forget(axis);  // the drive was lost during the writing
            }
            break;
        case Phase::Known:
            if (drive.report()->homeState != mine.homeState) {
                forget(axis);  // restarted, or set to another position
                state(axis).notBefore = now + kHeartbeat;
            } else {
                watchOrigin(axis, facts);
                watchEntered(axis, drive);
            }
            break;
    }
}

void TurnKeeper::becomeKnown(Axis axis, const Drive& drive)
{
    // Unless the judgement proved the wrap at once, the position of the drive was written since the last reading.
    const SteadyTime since = state(axis).phase == Phase::Unjudged ? state(axis).since : m_clock.now();
    state(axis) = {
        .phase = Phase::Known, .since = since, .homeState = drive.report()->homeState, .entered = state(axis).entered};
    m_log.add(Severity::Advisory, toQString(drive.name()), Text::tr("position confirmed"));
}

// Another wrap is excluded when it would have taken the axis beyond its stops. While it is not, and the end of the
// cable would be near on it, a pull may be that end.
void TurnKeeper::watchEntered(Axis axis, const Drive& drive)
{
    State& mine = state(axis);
    if (!mine.entered) {
        return;
    }
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    const Angle here = geometry.toAxis(drive.place()->position);
    *mine.entered = {.min = std::min(mine.entered->min, here), .max = std::max(mine.entered->max, here)};
    const auto& [low, high] = geometry.travel;
    const bool isBelow = mine.entered->min - kWrap >= low - journal::kBeyondTravel;
    const bool isAbove = mine.entered->max + kWrap <= high + journal::kBeyondTravel;
    mine.nearEnd = (isBelow && here - kWrap < low + kTightens) || (isAbove && here + kWrap > high - kTightens);
    if (!isBelow && !isAbove) {
        mine.entered.reset();
    }
}

// After a jog the axis is not where the journal has it.
void TurnKeeper::watchJog(Axis axis, const Drive& drive)
{
    if (record(axis) && drive.phase() != Drive::Phase::Referencing && abs(movedSince(axis, drive)) > kWorthNoting) {
        record(axis).reset();
        m_changed = true;
    }
}

journal::DriveFrame TurnKeeper::frame(Axis axis, const drive_check::DriveFacts& facts, const Drive& drive,
                                      SteadyTime now) const
{
    return {.drive = facts.uuid,
            .reported = drive.place()->position,
            .homeState = drive.report()->homeState,
            .uptime = Seconds(std::fmod(Seconds(now - facts.bootedAt).count(), kCounterSpan.count())),
            .origin = known(axis) ? state(axis).origin : facts.origin.origin,
            .outputEncoder = facts.outputEncoder,
            .period = period(axis, facts)};
}

void TurnKeeper::judgeAnew(Axis axis, const drive_check::DriveFacts& facts, Drive& drive, SteadyTime now)
{
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    const journal::DriveFrame met = frame(axis, facts, drive, now);
    const bool trusted = m_profile->axis(axis).powerUpPosition == profile::PowerUpPosition::Trusted ||
                         (m_start.trustFirstContact && !record(axis));
    const auto doubt = state(axis).doubt;
    const journal::Evidence evidence{.record = record(axis),
                                     .recordProblem = record(axis) ? QString() : m_start.problem,
                                     .sensorHeading = m_sensor[index(axis)],
                                     .now = m_clock.utc(),
                                     .host = journal::hostTime(m_clock),
                                     .trusted = trusted,
                                     .doubt = doubt};
    const journal::Judgement judgement = journal::reconcile(met, evidence, geometry);
    const auto entered = takeEnteredPlace(axis);
    if (const auto* const certain = std::get_if<journal::Certain>(&judgement)) {
        settle(axis, certain->angle, met.period, drive, QStringLiteral("station"), certain->why);
        return;
    }
    ask(axis, std::get<TurnQuestion>(judgement), drive);
    if (!entered || doubt || !chooseAsEntered(axis, *entered, drive)) {
        countFromTheMiddle(axis, drive);
    }
}

// The first judgement uses the entered position up, even if it does not need it, because the mount moves from then on.
std::optional<Angle> TurnKeeper::takeEnteredPlace(Axis axis)
{
    const auto place = std::exchange(m_start.standingAt[index(axis)], std::nullopt);
    if (place && enteredPlaceCounts()) {
        m_start.journal.placeUsed = m_start.looked;
        m_changed = true;
    }
    return place;
}

Result<> TurnKeeper::enteredPlaceCounts() const
{
    const auto age = std::chrono::floor<std::chrono::minutes>(m_clock.utc() - m_start.looked);
    if (m_placeUsedBefore) {
        return failure(ErrorCode::Refused, Text::tr("An earlier start has used this position. It counts once."));
    }
    if (age >= kPlaceAge) {
        return failure(ErrorCode::Refused, Text::tr("The entered position is %1 min old. It is valid for %2 min.")
                                               .arg(age.count())
                                               .arg(kPlaceAge.count()));
    }
    if (age < -kClockError) {
        return failure(ErrorCode::Refused,
                       Text::tr("The entered time is in the future. Check the clock of this computer."));
    }
    return {};
}

bool TurnKeeper::chooseAsEntered(Axis axis, Angle place, Drive& drive)
{
    const QString source = QStringLiteral("command line");
    const Result<> chosen = enteredPlaceCounts().and_then([&] { return choose(axis, place, drive, source); });
    if (!chosen) {
        m_placeProblems[index(axis)] = chosen.error().text;
    }
    return chosen.has_value();
}

void TurnKeeper::ask(Axis axis, const TurnQuestion& question, const Drive& drive)
{
    state(axis).phase = Phase::Asked;
    state(axis).question = question;
    state(axis).reportedWhenAsked = drive.place()->position;
    QString text = Text::tr("the cable wrap is unknown, so pointing is blocked until the operator enters the position");
    TurnQuestion told = question;
    addTurning(axis, told);
    for (const QString& line : told.evidence) {
        text += QStringLiteral(". ") + line;
    }
    m_log.add(Severity::Warning, toQString(drive.name()), text);
}

// Outside its own bounds a drive refuses to move, and its time-out mode would pull the axis to the nearer bound.
void TurnKeeper::countFromTheMiddle(Axis axis, Drive& drive)
{
    State& mine = state(axis);
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    const Angle middle = (geometry.travel.min + geometry.travel.max) * 0.5;
    const Angle reported = geometry.toAxis(drive.place()->position);
    const Angle period = mine.question.period;
    const bool phaseKnown = drive.report()->homeState != moteus::HomeState::Relative && period > Angle{};
    const Angle place = phaseKnown ? reported + period * std::round((middle - reported) / period) : middle;
    mine.reportedWhenAsked = geometry.toMotor(place);
    drive.reference(geometry.toMotor(place), tolerance(axis, period));
}

// The tolerance of a position in turns of the drive: less than half of the period that the drive can not resolve.
MotorTurns TurnKeeper::tolerance(Axis axis, Angle period) const
{
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    const Angle quarter = period > Angle{} ? period * 0.25 : kLoneTolerance;
    return abs(geometry.toMotor(geometry.travel.min + quarter) - geometry.toMotor(geometry.travel.min));
}

Angle TurnKeeper::movedSince(Axis axis, const Drive& drive) const
{
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    return geometry.toAxis(drive.place()->position) - geometry.toAxis(state(axis).reportedWhenAsked);
}

std::optional<TurnQuestion> TurnKeeper::question(Axis axis, const Drive& drive) const
{
    const State& mine = state(axis);
    if (mine.phase != Phase::Asked || !drive.report() || !drive.place()) {
        return std::nullopt;
    }
    TurnQuestion question = mine.question;
    question.evidence.back() = journal::sensorSentence(m_sensor[index(axis)]);  // may have changed since
    question.movedSince = drive.phase() == Drive::Phase::Referencing ? Angle{} : movedSince(axis, drive);
    if (question.candidates.empty()) {
        addTurning(axis, question);
        return question;
    }
    // The present candidates: by jogging, one may have come inside the stops and another may have left them.
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    question.candidates =
        journal::placesAround(geometry.toAxis(drive.place()->position), question.period, geometry.travel);
    if (question.proposed) {
        const Angle wandered = *question.proposed + question.movedSince;
        question.proposed = sameAmong(question.candidates, wandered, question.period);
    }
    addTurning(axis, question);
    return question;
}

void TurnKeeper::addTurning(Axis axis, TurnQuestion& question) const
{
    const auto place = axis == Axis::Azimuth ? journal::placeBySensor(m_anchor, m_course) : std::nullopt;
    if (place) {
        journal::addSensorTurning(question, *place);
    }
}

Result<> TurnKeeper::mayChoose(Axis axis, const Drive& drive) const
{
    if (!question(axis, drive)) {
        return failure(ErrorCode::Refused,
                       Text::tr("Boresight did not ask for the axis position of the %1.").arg(drive.label()));
    }
    if (!drive.canBeReferenced()) {
        return failure(ErrorCode::Refused, Text::tr("The drive is busy. Try again in a second."));
    }
    return {};
}

Result<> TurnKeeper::choose(Axis axis, Angle angle, Drive& drive, const QString& source)
{
    if (Result<> may = mayChoose(axis, drive); !may) {
        return may;
    }
    const auto asked = question(axis, drive);
    Angle place = angle;
    if (!asked->candidates.empty()) {
        place = nearestOf(asked->candidates, angle);
        if (abs(place - angle) > std::min(kEyeSight, asked->period * 0.5)) {
            return failure(ErrorCode::Refused,
                           Text::tr("the drive contradicts %1. The nearest position that the drive permits is %2. If "
                                    "that position is wrong, another tool has set the position of the drive. Switch "
                                    "the power of the drive off and on")
                               .arg(degreesText(angle), degreesText(place)));
        }
    }
    const TravelRange& travel = m_profile->axis(axis).geometry.travel;
    if (place < travel.min - journal::kBeyondTravel || place > travel.max + journal::kBeyondTravel) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("%1 is outside the travel (%2 to %3) by more than %4. Enter the angle of the axis.")
                           .arg(degreesText(place), degreesText(travel.min), degreesText(travel.max),
                                degreesText(journal::kBeyondTravel)));
    }
    if (drive.report()->mode != moteus::Mode::Stopped && beyondBounds(place, travel, *m_profile)) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 is beyond the bounds of the drive, which would pull the axis back at once. Support "
                                "the elevation and switch the drives off first.")
                           .arg(degreesText(place)));
    }
    settle(axis, place, asked->period, drive, source, Text::tr("chosen"));
    state(axis).entered = TravelRange{.min = place, .max = place};
    return {};
}

void TurnKeeper::settle(Axis axis, Angle angle, Angle period, Drive& drive, const QString& source, const QString& why)
{
    m_log.add(Severity::Advisory, source, Text::tr("%1 stands at %2: %3").arg(drive.label(), degreesText(angle), why));
    const pointing::AxisGeometry& geometry = m_profile->axis(axis).geometry;
    const MotorTurns place = geometry.toMotor(angle);
    const MotorTurns near = tolerance(axis, period);
    const bool there = abs(drive.place()->position - place) < near;
    const bool trusted = m_profile->axis(axis).powerUpPosition == profile::PowerUpPosition::Trusted;
    if (there && (trusted || drive.report()->homeState == moteus::HomeState::Output)) {
        becomeKnown(axis, drive);
        return;
    }
    state(axis) = {.phase = Phase::Writing, .entered = state(axis).entered};
    drive.reference(place, near);
}

void TurnKeeper::note(Axis axis, const drive_check::DriveFacts& facts, const Drive& drive, bool moving, SteadyTime now)
{
    State& mine = state(axis);
    if (mine.phase != Phase::Known || !drive.place() || !drive.answering(now)) {
        return;
    }
    const Angle angle = m_profile->axis(axis).geometry.toAxis(drive.place()->position);
    if (axis == Axis::Azimuth) {
        m_anchor = m_course ? std::optional(journal::CourseAnchor{.axis = angle, .course = *m_course}) : m_anchor;
    }
    const journal::DriveFrame here = frame(axis, facts, drive, now);
    auto& last = record(axis);
    const bool turned = !last || last->drive != facts.uuid || last->moving != moving || last->origin != here.origin;
    const SteadyTime::duration sinceNoted = mine.noted ? now - *mine.noted : SteadyTime::duration::max();
    const Angle step = moving ? std::max(kWorthNoting, journal::journalStep(here.period)) : kWorthNoting;
    const bool elsewhere = last && abs(last->angle - angle) > step && sinceNoted >= kMovingPeriod;
    if (turned || !mine.noted || elsewhere || sinceNoted >= kRestingPeriod) {
        last = journal::recordOf(here, angle, m_profile->axis(axis).geometry, moving, m_clock.utc(),
                                 journal::hostTime(m_clock));
        mine.noted = now;
        m_changed = true;
    }
}

void TurnKeeper::keep(Axis axis, const CrashStop& stop)
{
    m_start.journal.crashStops[index(axis)] = stop;
    m_changed = true;
}

}  // namespace boresight

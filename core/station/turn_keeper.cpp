// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/turn_keeper.h"

#include "core/base/numbers.h"
#include "core/station/drive_alarms.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// While it moves an axis is written down this often; a crash-safe write takes some milliseconds on a disk.
constexpr std::chrono::seconds kMovingPeriod{1};
// At rest only what has changed, and now and then the time: the younger the record, the better the proof.
constexpr std::chrono::minutes kRestingPeriod{5};
constexpr Angle kWorthNoting = Angle::fromDegrees(0.1);
// An eye at the mast is this good.
constexpr Angle kEyeSight = Angle::fromDegrees(20.0);
// Without candidates there is no period to derive it from.
constexpr Angle kLoneTolerance = Angle::fromDegrees(1.0);

QString degreesText(Angle angle)
{
    return QString::fromStdString(formatFixed(angle.degrees(), 1)) + QStringLiteral("°");
}

Angle nearestOf(const std::vector<Angle>& candidates, Angle angle)
{
    return *std::ranges::min_element(candidates, {}, [angle](Angle one) { return abs(one - angle).radians(); });
}

}  // namespace

TurnKeeper::TurnKeeper(const profile::Profile& profile, const Clock& clock, EventLog& log, Start start)
    : m_profile(profile), m_clock(clock), m_log(log), m_start(std::move(start))
{}

const profile::AxisSettings& TurnKeeper::settings(Axis axis) const
{
    return axis == Axis::Azimuth ? m_profile.azimuth : m_profile.elevation;
}

std::optional<memory::TurnRecord>& TurnKeeper::record(Axis axis)
{
    return m_start.memory.turns[index(axis)];
}

void TurnKeeper::forget(Axis axis, const std::optional<QString>& doubt)
{
    state(axis) = {.doubt = doubt ? doubt : state(axis).doubt, .otherHands = state(axis).otherHands};
}

void TurnKeeper::forgetAfterOthers(Axis axis)
{
    forget(axis);
    state(axis).otherHands = true;
}

// A tool that moved the axis may also have set the drive's position, and nothing would show it.
std::optional<QString> TurnKeeper::doubtOf(Axis axis, const DriveReport& report)
{
    const pointing::AxisGeometry& geometry = settings(axis).geometry;
    const bool untouched = record(axis) && abs(geometry.toAxis(*report.position) -
                                               geometry.toAxis(record(axis)->reported)) < kWorthNoting * 2.0;
    if (state(axis).otherHands && !untouched) {
        return QStringLiteral("Other tools had the bus, and the drive reports another place than before");
    }
    return state(axis).doubt;
}

void TurnKeeper::judge(Axis axis, const survey::DriveFacts& facts, Drive& drive, SteadyTime now)
{
    State& mine = state(axis);
    const bool reported = drive.report() && drive.report()->position && drive.answering(now);
    if (mine.phase == Phase::Unjudged && reported && drive.canBeReferenced()) {
        judgeAnew(axis, facts, drive, now);
    } else if (mine.phase == Phase::Writing && drive.takeReferenced()) {
        mine = {.phase = Phase::Known};
        m_log.add(Severity::Advisory, drive_alarms::toQString(drive.name()),
                  QStringLiteral("has taken its place: the turn is known"));
    }
}

memory::DriveFrame TurnKeeper::frame(Axis axis, const survey::DriveFacts& facts, const DriveReport& report,
                                     SteadyTime now) const
{
    return {.drive = facts.uuid,
            .reported = *report.position,
            .homeState = report.homeState,
            .uptime = now - facts.bootedAt,
            .outputEncoder = facts.outputEncoder,
            .period = memory::ambiguity(settings(axis).geometry, facts.rotorToOutputRatio, facts.outputEncoder)};
}

void TurnKeeper::judgeAnew(Axis axis, const survey::DriveFacts& facts, Drive& drive, SteadyTime now)
{
    const pointing::AxisGeometry& geometry = settings(axis).geometry;
    const memory::DriveFrame met = frame(axis, facts, *drive.report(), now);
    const bool trusted = settings(axis).powerUpPosition == profile::PowerUpPosition::Trusted ||
                         (m_start.trustFirstContact && !record(axis));
    const memory::Evidence evidence{.record = record(axis),
                                    .recordProblem = record(axis) ? QString() : m_start.problem,
                                    .now = m_clock.utc(),
                                    .host = memory::hostTime(m_clock),
                                    .trusted = trusted,
                                    .doubt = doubtOf(axis, *drive.report())};
    const memory::Judgement judgement = memory::reconcile(met, evidence, geometry);
    if (const auto* const certain = std::get_if<memory::Certain>(&judgement)) {
        m_start.standingAt[index(axis)].reset();
        settle(axis, certain->angle, met.period, drive, QStringLiteral("station"), certain->why);
        return;
    }
    ask(axis, std::get<memory::TurnQuestion>(judgement), drive);
    if (const auto place = std::exchange(m_start.standingAt[index(axis)], std::nullopt)) {
        const QString source = QStringLiteral("command line");
        if (const Result<> chosen = choose(axis, *place, drive, source); !chosen) {
            m_log.add(Severity::Warning, source, QString::fromStdString(chosen.error().text));
        }
    }
}

void TurnKeeper::ask(Axis axis, const memory::TurnQuestion& question, Drive& drive)
{
    state(axis).phase = Phase::Asked;
    state(axis).question = question;
    state(axis).reportedWhenAsked = *drive.report()->position;
    QString text = QStringLiteral("the turn of the axis is not known: no pointing until the operator has told it");
    for (const QString& line : question.evidence) {
        text += QStringLiteral(". ") + line;
    }
    m_log.add(Severity::Warning, drive_alarms::toQString(drive.name()), text);
}

Angle TurnKeeper::movedSince(Axis axis, const Drive& drive) const
{
    const pointing::AxisGeometry& geometry = settings(axis).geometry;
    return geometry.toAxis(*drive.report()->position) - geometry.toAxis(state(axis).reportedWhenAsked);
}

std::optional<memory::TurnQuestion> TurnKeeper::question(Axis axis, const Drive& drive) const
{
    const State& mine = state(axis);
    if (mine.phase != Phase::Asked || !drive.report() || !drive.report()->position) {
        return std::nullopt;
    }
    memory::TurnQuestion question = mine.question;
    question.movedSince = movedSince(axis, drive);
    for (Angle& candidate : question.candidates) {
        candidate += question.movedSince;
    }
    if (question.proposed) {
        *question.proposed += question.movedSince;
    }
    return question;
}

Result<> TurnKeeper::choose(Axis axis, Angle angle, Drive& drive, const QString& source)
{
    const auto asked = question(axis, drive);
    if (!asked) {
        return failure(ErrorCode::Refused, "nobody has asked where the " + drive.name() + "'s axis stands");
    }
    if (!drive.canBeReferenced()) {
        return failure(ErrorCode::Refused, "the drive is busy: try again in a second");
    }
    Angle place = angle;
    if (!asked->candidates.empty()) {
        place = nearestOf(asked->candidates, angle);
        if (abs(place - angle) > std::min(kEyeSight, asked->period * 0.5)) {
            return failure(ErrorCode::Refused, "the drive's direction contradicts " + degreesText(angle).toStdString() +
                                                   ": the nearest it can be at is " + degreesText(place).toStdString());
        }
    }
    settle(axis, place, asked->period, drive, source, QStringLiteral("chosen"));
    return {};
}

void TurnKeeper::settle(Axis axis, Angle angle, Angle period, Drive& drive, const QString& source, const QString& why)
{
    m_log.add(
        Severity::Advisory, source,
        QStringLiteral("%1 stands at %2: %3").arg(drive_alarms::toQString(drive.name()), degreesText(angle), why));
    const pointing::AxisGeometry& geometry = settings(axis).geometry;
    const MotorTurns place = geometry.toMotor(angle);
    const Angle quarter = period > Angle{} ? period * 0.25 : kLoneTolerance;
    const MotorTurns tolerance =
        abs(geometry.toMotor(geometry.travel.min + quarter) - geometry.toMotor(geometry.travel.min));
    const DriveReport& report = *drive.report();
    const bool there = abs(*report.position - place) < tolerance;
    const bool trusted = settings(axis).powerUpPosition == profile::PowerUpPosition::Trusted;
    if (there && (trusted || report.homeState == moteus::HomeState::Output)) {
        state(axis) = {.phase = Phase::Known};
        return;
    }
    state(axis) = {.phase = Phase::Writing};
    drive.reference(place, tolerance);
}

void TurnKeeper::note(Axis axis, const survey::DriveFacts& facts, const Drive& drive, bool moving, SteadyTime now)
{
    State& mine = state(axis);
    if (mine.phase != Phase::Known || !drive.report()->position || !drive.answering(now)) {
        return;
    }
    const Angle angle = settings(axis).geometry.toAxis(*drive.report()->position);
    auto& last = record(axis);
    const bool turned = !last || last->drive != facts.uuid || last->moving != moving;
    const SteadyTime::duration sinceNoted = mine.noted ? now - *mine.noted : SteadyTime::duration::max();
    const bool elsewhere = last && abs(last->angle - angle) > kWorthNoting && sinceNoted >= kMovingPeriod;
    if (turned || !mine.noted || elsewhere || sinceNoted >= kRestingPeriod) {
        last = memory::recordOf(frame(axis, facts, *drive.report(), now), angle, settings(axis).geometry, moving,
                                m_clock.utc(), memory::hostTime(m_clock));
        mine.noted = now;
        m_changed = true;
    }
}

void TurnKeeper::keep(Axis axis, const memory::CrashStop& stop)
{
    m_start.memory.crashStops[index(axis)] = stop;
    m_changed = true;
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/reconcile.h"

#include "core/base/text.h"
#include "core/journal/place_words.h"
#include "core/journal/places.h"
#include "core/journal/power_proof.h"
#include "core/units/degrees_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace boresight::journal {
namespace {

// Scenario S10: how far a mount may move while the program does not run.
const Angle kAgreement = Angle::fromDegrees(5.0);
// If the possible places are close together, an axis that was moved anywhere agrees with the journal by chance with
// this probability.
constexpr double kLuck = 0.05;
// With a shorter period a moving axis reaches another of its possible places within one or two seconds.
const Angle kWidePeriod = Angle::fromDegrees(20.0);
// A smaller period is invalid, for example from a gear ratio of zero.
const Angle kSmallestPeriod = Angle::fromDegrees(0.01);
constexpr MotorTurns kPositionRange = MotorTurns::fromTurns(32768.0);  // where the drive's register wraps
constexpr std::size_t kNamedCandidates = 5;                            // more candidates are shown as a range

Angle agreement(Angle period)
{
    return std::min(kAgreement, period * (kLuck / 2.0));
}

bool knowsItsPhase(const DriveFrame& frame)
{
    const auto wanted = frame.outputEncoder ? moteus::HomeState::Output : moteus::HomeState::Rotor;
    const bool possible = frame.reported.isFinite() && abs(frame.reported) <= kPositionRange;
    return frame.homeState >= wanted && possible && frame.period.isFinite() && frame.period >= kSmallestPeriod;
}

std::optional<Angle> nearest(const std::vector<Angle>& candidates, Angle place)
{
    const auto found = std::min_element(candidates.begin(), candidates.end(),
                                        [&](Angle a, Angle b) { return abs(a - place) < abs(b - place); });
    return found == candidates.end() ? std::nullopt : std::optional(*found);
}

// One decision about a drive: the values that the judgement and its sentences share.
class Case
{
public:
    Case(const DriveFrame& frame, const Evidence& evidence, const pointing::AxisGeometry& axis)
        : m_frame(frame), m_evidence(evidence), m_axis(axis)
    {
        if (evidence.record) {
            m_obstacle = obstacleToCountingOn(frame, evidence, *evidence.record, axis);
            m_ofThisDrive = !frame.drive.isEmpty() && evidence.record->drive == frame.drive;
        }
        m_phaseKnown = knowsItsPhase(frame) && !(m_obstacle && m_obstacle->phaseLost);
        if (m_phaseKnown) {
            m_candidates = placesAround(axis.toAxis(frame.reported), frame.period, axis.travel);
        }
    }

    [[nodiscard]] Judgement judge() const
    {
        const Angle reported = m_axis.toAxis(m_frame.reported);
        if (m_evidence.trusted && !m_evidence.doubt && m_frame.homeState != moteus::HomeState::Relative &&
            reported.isFinite()) {
            return Certain{reported, Text::tr("The profile trusts the drive's position")};
        }
        if (!m_evidence.doubt) {
            if (const auto angle = countedOn()) {
                return Certain{*angle, Text::tr("The drive kept its power since the journal was written")};
            }
        }
        return TurnQuestion{
            .candidates = m_candidates, .proposed = proposal(), .evidence = sentences(), .period = m_frame.period};
    }

private:
    [[nodiscard]] std::optional<Angle> countedOn() const
    {
        if (!m_evidence.record || m_obstacle || !m_phaseKnown) {
            return std::nullopt;
        }
        const TurnRecord& record = *m_evidence.record;
        return record.angle + (m_axis.toAxis(m_frame.reported) - m_axis.toAxis(record.reported));
    }

    // The candidate nearest to the angle in the journal. Empty if the journal is of another drive.
    [[nodiscard]] std::optional<Angle> nearestToJournal() const
    {
        return m_ofThisDrive ? nearest(m_candidates, m_evidence.record->angle) : std::nullopt;
    }

    [[nodiscard]] bool agrees(Angle place) const
    {
        return abs(place - m_evidence.record->angle) <= agreement(m_frame.period);
    }

    [[nodiscard]] bool journalIsVague() const
    {
        const TurnRecord& record = *m_evidence.record;
        return (record.moving || record.provesNothing()) && m_frame.period < kWidePeriod;
    }

    [[nodiscard]] std::optional<Angle> proposal() const
    {
        if (m_evidence.doubt || (m_obstacle && m_obstacle->positionSet)) {
            return std::nullopt;
        }
        if (!m_evidence.record) {
            const bool only = m_frame.outputEncoder && m_candidates.size() == 1;
            return only ? std::optional(m_candidates.front()) : std::nullopt;
        }
        const auto place = nearestToJournal();
        return place && agrees(*place) && !journalIsVague() ? place : std::nullopt;
    }

    [[nodiscard]] std::vector<QString> sentences() const
    {
        std::vector<QString> all;
        if (m_evidence.doubt) {
            all.push_back(*m_evidence.doubt);
        }
        all.push_back(placeSentence());
        addJournal(all);
        all.push_back(sensorSentence(m_evidence.sensorHeading));
        return all;
    }

    [[nodiscard]] QString placeSentence() const
    {
        if (!m_phaseKnown) {
            return Text::tr("The drive does not know the position of the axis. Enter the angle");
        }
        if (m_candidates.empty()) {
            return Text::
                tr("The drive reports %1. No cable wrap of this angle lies within %2° of the travel. Enter the angle")
                    .arg(inWords(m_axis.toAxis(m_frame.reported)))
                    .arg(kBeyondTravel.degrees());
        }
        if (m_candidates.size() == 1) {
            return Text::tr("The position that the drive reports fits only %1").arg(inWords(m_candidates.front()));
        }
        if (m_candidates.size() > kNamedCandidates) {
            return Text::tr("The angle is known only to a multiple of %1. %2 places from %3 to %4 are possible")
                .arg(inWords(m_frame.period))
                .arg(m_candidates.size())
                .arg(inWords(m_candidates.front()), inWords(m_candidates.back()));
        }
        return m_frame.outputEncoder ? Text::tr("Direction %1 is known, but not the cable wrap. %2 are possible")
                                           .arg(azimuthText(m_candidates.front()), namedCandidates())
                                     : Text::tr("The angle is known only to a multiple of %1. %2 are possible")
                                           .arg(inWords(m_frame.period), namedCandidates());
    }

    [[nodiscard]] QString namedCandidates() const
    {
        QStringList all;
        for (const Angle candidate : m_candidates) {
            all.push_back(inWords(candidate));
        }
        const QString last = all.takeLast();
        return Text::tr("%1 or %2").arg(all.join(QStringLiteral(", ")), last);
    }

    void addJournal(std::vector<QString>& all) const
    {
        if (!m_evidence.recordProblem.isEmpty()) {
            all.push_back(m_evidence.recordProblem);
        }
        if (!m_evidence.record) {
            if (m_evidence.recordProblem.isEmpty()) {
                all.push_back(Text::tr("The journal has no entry for this axis"));
            }
            return;
        }
        all.push_back(journalSentence(*m_evidence.record));
        if (m_obstacle) {
            all.push_back(m_obstacle->why);
        }
        addComparison(all);
    }

    // Without the age if the clock was set back.
    [[nodiscard]] QString journalSentence(const TurnRecord& record) const
    {
        const QString angle = inWords(record.angle);
        const Seconds age = m_evidence.now - record.when;
        if (age < Seconds(0.0)) {
            return (record.moving ? Text::tr("The journal has %1, written in motion")
                                  : Text::tr("The journal has %1, written at standstill"))
                .arg(angle);
        }
        return (record.moving ? Text::tr("The journal has %1, %2 old, written in motion")
                              : Text::tr("The journal has %1, %2 old, written at standstill"))
            .arg(angle, inWords(age));
    }

    void addComparison(std::vector<QString>& all) const
    {
        const auto place = nearestToJournal();
        if (!place) {
            return;
        }
        if (!agrees(*place)) {
            all.push_back(Text::tr("The nearest possible position is %1 from the position in the journal. The axis "
                                   "moved while Boresight did not watch it")
                              .arg(inWords(abs(*place - m_evidence.record->angle))));
        } else if (journalIsVague()) {
            all.push_back(Text::tr("The axis may have moved since then. The drive cannot distinguish places %1 apart, "
                                   "so the journal does not show which place is right")
                              .arg(inWords(m_frame.period)));
        }
    }

    const DriveFrame& m_frame;
    const Evidence& m_evidence;
    const pointing::AxisGeometry& m_axis;
    std::vector<Angle> m_candidates;
    std::optional<Obstacle> m_obstacle;  // why the drive's count may not be continued from the record
    bool m_ofThisDrive = false;          // the record is of this drive
    bool m_phaseKnown = false;           // the reported position is correct to whole periods
};

}  // namespace

Angle ambiguity(const pointing::AxisGeometry& axis, double rotorToOutputRatio, bool outputEncoder)
{
    const MotorTurns turn = MotorTurns::fromTurns(outputEncoder ? 1.0 : rotorToOutputRatio);
    return abs(axis.toAxis(turn) - axis.toAxis(MotorTurns()));
}

// With a shorter period nothing is proposed after a motion, and the record only shows roughly where the axis was.
Angle journalStep(Angle period)
{
    return (period < kWidePeriod ? kAgreement : agreement(period)) * 0.5;
}

QString sensorSentence(const std::optional<Angle>& heading)
{
    return heading ? Text::tr("The sensor reports %1").arg(azimuthText(*heading))
                   : Text::tr("There is no sensor to compare with");
}

Judgement reconcile(const DriveFrame& frame, const Evidence& evidence, const pointing::AxisGeometry& axis)
{
    return Case(frame, evidence, axis).judge();
}

TurnRecord recordOf(const DriveFrame& frame, Angle angle, const pointing::AxisGeometry& axis, bool moving, UtcTime now,
                    const HostTime& host)
{
    return {.drive = frame.drive,
            .angle = angle,
            .reported = frame.reported,
            .counted = axis.toAxis(frame.reported),
            .uptime = frame.uptime,
            .homeState = frame.homeState,
            .origin = frame.origin,
            .when = now,
            .host = host,
            .moving = moving};
}

}  // namespace boresight::journal

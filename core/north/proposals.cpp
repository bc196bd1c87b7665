// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/proposals.h"

#include "core/base/text.h"
#include "core/cross_check/sensor_curve.h"
#include "core/north/same_terms.h"

#include <utility>

namespace boresight {
namespace {

const QString kProposalsSource = QStringLiteral("calibration");
// A larger change of the declination moves the north that the sensor found.
constexpr Angle kSameDeclination = Angle::fromDegrees(0.05);

}  // namespace

Proposals::Proposals(const profile::InForce& profile, const LiveSensor& sensor, const ModelInForce& model,
                     const KeptPoints& points, EventLog& log)
    : m_profile(profile), m_sensor(sensor), m_model(model), m_points(points), m_log(log)
{}

void Proposals::propose(const calibration::SensorOffset& offset)
{
    m_sensorOffset = offset;
    proposeFrom(From::SensorOffset);
}

void Proposals::propose(const SwungCompass& swung)
{
    m_swung = swung;
    if (m_swung.outcome->fit.isUsable()) {
        proposeFrom(From::Swing);
    }
}

Result<> Proposals::propose(GivenTerms given)
{
    return asSettings(given.terms).and_then([&](const auto& terms) -> Result<> {
        if (isSame(terms, m_profile->pointing)) {
            return failure(ErrorCode::Refused, Text::tr("These terms are already in force."));
        }
        given.terms = changedOnly(terms, m_profile->pointing);
        m_given = std::move(given);
        proposeFrom(From::Entered);
        return {};
    });
}

void Proposals::pointsChanged()
{
    m_fitDiscarded = false;
    const From other = m_from == From::Points ? From::Nothing : m_from;
    proposeFrom(m_points.book().fitted() ? From::Points : other);
}

void Proposals::pointsRestored()
{
    if (m_points.contradictModel() && m_from == From::Nothing) {
        proposeFrom(From::Points);
    }
}

void Proposals::renewPoints()
{
    if (m_from == From::Points) {
        proposeFrom(m_from);
    }
}

// The proposal is compared with the new profile. The fit of the points may already be in force.
void Proposals::profileChanged(bool otherSensor)
{
    if (otherSensor) {
        m_declination = Angle::fromTurns(1.0);  // makes dropStale() drop what was found with the old settings
        dropStale();
    }
    proposeFrom(m_from == From::Points && !m_points.contradictModel() ? From::Nothing : m_from);
}

// A north found by the sensor is valid only with the mounting, the sense and the declination of its measurement.
void Proposals::dropStale()
{
    if (isOfSensor() && abs(m_sensor.declination() - m_declination) > kSameDeclination) {
        m_sensorOffset.reset();
        proposeFrom(From::Nothing);
        m_log.add(
            Severity::Warning, kProposalsSource,
            Text::tr(
                "The settings of the sensor or the declination changed, so the proposal is dropped. Measure again"));
    }
}

Result<> Proposals::discard(std::uint64_t number)
{
    return isCurrent(number).map([&] {
        m_log.add(Severity::Advisory, QStringLiteral("operator"), Text::tr("discards \"%1\"").arg(m_proposal->title));
        m_fitDiscarded = m_fitDiscarded || m_from == From::Points;
        proposeFrom(From::Nothing);
    });
}

void Proposals::clear(Next next)
{
    m_from = next == Next::Points ? From::Points : From::Nothing;
    m_proposal.reset();
}

Result<> Proposals::isCurrent(std::uint64_t number) const
{
    if (!m_proposal) {
        return failure(ErrorCode::Refused, Text::tr("Nothing is proposed yet."));
    }
    return m_proposal->number == number
               ? Result<>{}
               : failure(ErrorCode::Refused, Text::tr("The proposal has changed. Read it again first."));
}

Result<> Proposals::mayApply(const request::ApplyCalibration& wanted) const
{
    return isCurrent(wanted.proposal).and_then([&]() -> Result<> {
        return m_proposal->doubts.empty() || wanted.overridesDoubts
                   ? Result<>{}
                   : failure(ErrorCode::Refused,
                             Text::tr("This result is unreliable. %1 To use it, press Apply anyway.")
                                 .arg(m_proposal->doubts.front()));
    });
}

bool Proposals::isFound(calibration::Term term) const
{
    switch (m_from) {
        case From::Points:
            return m_points.book().fitted() &&
                   m_points.book().fitted()->of(term).state == calibration::TermState::Fitted;
        case From::Entered:
            return calibration::valueOf(m_proposal->terms, term) != calibration::valueOf(m_profile->pointing, term);
        default:
            return m_proposal->sigmas[calibration::indexOf(term)].has_value();
    }
}

std::optional<CalibrationChange> Proposals::ofSensor() const
{
    if (!isOfSensor() || !m_proposal) {
        return std::nullopt;
    }
    return CalibrationChange{.terms = m_proposal->terms,
                             .sensor = m_proposal->sensor.value_or(mountingOf(m_profile->sensor))};
}

void Proposals::proposeFrom(From from)
{
    m_from = from;
    m_declination = m_sensor.declination();
    m_proposal = made();
    if (!m_proposal) {
        return;
    }
    if (m_points.axesMayDiffer(m_proposal->points)) {
        m_proposal->warnings.push_back(
            Text::tr("You entered the cable wrap again after the first of these points. If the wrap changed, the "
                     "points do not fit together. Then drop the older points."));
    }
    m_proposal->number = ++m_count;
}

Proposal Proposals::madeOfSwing() const
{
    Proposal proposal = proposalOf(*m_swung.outcome, *m_profile, m_model.toldByPoints());
    if (!m_swung.doubt.isEmpty()) {
        proposal.doubts.push_back(m_swung.doubt);
    }
    return proposal;
}

std::optional<Proposal> Proposals::made() const
{
    switch (m_from) {
        case From::SensorOffset:
            return proposalOf(*m_sensorOffset, *m_profile, m_model.toldByPoints());
        case From::Swing:
            return madeOfSwing();
        case From::Points:
            return m_points.book().fitted() && !m_fitDiscarded
                       ? std::optional(proposalOf(*m_points.book().fitted(), m_points.book().points(), *m_profile,
                                                  m_model.toldByPoints()))
                       : std::nullopt;
        case From::Entered:
            return proposalOf(m_given, *m_profile);
        case From::Nothing:
            break;
    }
    return std::nullopt;
}

}  // namespace boresight

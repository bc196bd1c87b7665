// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk for terms that are given, typed or from a text; and for what holds of those in force: how
// exact they are, and for which mount.
#include "core/base/text.h"
#include "core/north/calibration_desk.h"
#include "core/north/same_terms.h"
#include "core/witness/sensor_curve.h"

#include <algorithm>

namespace boresight {
namespace {

const QString kTermsSource = QStringLiteral("calibration");

// A declination that moved by more has moved north.
constexpr Angle kSameDeclination = Angle::fromDegrees(0.05);

}  // namespace

Result<> CalibrationDesk::handle(const request::ProposeTerms& wanted)
{
    return proposeGiven({.title = Text::tr("Typed terms"), .reason = Text::tr("typed"), .terms = wanted.terms});
}

Result<> CalibrationDesk::handle(const request::ImportTerms& wanted)
{
    return calibration::parseTerms(wanted.text, wanted.name.toStdString())
        .and_then([&](const calibration::TermSheet& read) {
            return proposeGiven({.title = Text::tr("Terms from %1").arg(wanted.name),
                                 .reason = Text::tr("from a file"),
                                 .terms = read.terms,
                                 .sigmas = read.sigmas,
                                 .warnings = otherMountWarnings(read, m_model.sheet())});
        });
}

Result<> CalibrationDesk::proposeGiven(GivenTerms given)
{
    return nothingRuns().and_then([&] { return asSettings(given.terms); }).and_then([&](const auto& terms) -> Result<> {
        if (isSame(terms, m_profile.pointing)) {
            return failure(ErrorCode::Refused, Text::tr("these are the terms that are in force already"));
        }
        given.terms = changedOnly(terms, m_profile.pointing);
        m_given = std::move(given);
        propose(ProposedBy::Given);
        return {};
    });
}

// What was typed since would be lost without a word.
Result<> CalibrationDesk::stillInForce(const pointing::PointingTerms& terms,
                                       const std::optional<calibration::SensorMounting>& sensor) const
{
    if (!isSame(terms, m_profile.pointing)) {
        return failure(ErrorCode::Refused,
                       Text::tr("the pointing model was changed since, %1, and that would be lost: take it back on the "
                                "page Profile first, or type the terms that you want")
                           .arg(changeText(terms, m_profile.pointing)));
    }
    if (sensor && !isSame(*sensor, mountingOf(m_profile.sensor))) {
        return failure(ErrorCode::Refused,
                       Text::tr("the sensor's mounting or deviation was changed since, and that would be lost: take it "
                                "back on the page Profile first"));
    }
    return {};
}

// A sensor's north holds with the mounting, the sense and the declination that it was found with.
void CalibrationDesk::dropStale()
{
    const bool bySensor = m_by == ProposedBy::SensorOffset || m_by == ProposedBy::Swing;
    if (bySensor && abs(m_sensor.declination() - m_proposedAt) > kSameDeclination) {
        m_sensorOffset.reset();
        propose(ProposedBy::Nothing);
        m_log.add(Severity::Warning, kTermsSource,
                  Text::tr("the settings of the sensor or the declination have changed: what was found with the former "
                           "is not proposed any more; measure again"));
    }
}

void CalibrationDesk::warnOfOtherMount(const calibration::CalibrationRecord& record)
{
    if (calibration::difference(record.mount, m_mount.today()) != calibration::MountDifference::None) {
        m_log.add(
            Severity::Warning, kTermsSource,
            Text::tr("\"%1\" was applied with another drive or at another site: see where north is before you rely "
                     "on what comes into force")
                .arg(toQString(record.title)));
    }
}

// Also the points that wait for both drives may count now.
void CalibrationDesk::noteDrives()
{
    if (m_mount.update()) {
        m_changed = true;
        if (m_points.leaveOutOthers()) {
            pointsChanged();
        }
        if (m_points.countRestored() && m_points.contradictModel() && m_by == ProposedBy::Nothing) {
            propose(ProposedBy::Points);
        }
    }
}

void CalibrationDesk::watchPoints()
{
    if (m_points.leaveOutOthers()) {
        pointsChanged();
    }
    if (m_points.noteTurns() && m_by == ProposedBy::Points) {
        propose(m_by);
    }
}

}  // namespace boresight

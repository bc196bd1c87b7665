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

}  // namespace

Result<> CalibrationDesk::handle(const request::ProposeTerms& wanted)
{
    return m_runs.isIdle().and_then([&] {
        return m_proposals.propose(
            {.title = Text::tr("Typed terms"), .reason = Text::tr("typed"), .terms = wanted.terms});
    });
}

Result<> CalibrationDesk::handle(const request::ImportTerms& wanted)
{
    const auto read = calibration::parseTerms(wanted.text, wanted.name.toStdString());
    if (!read) {
        return tl::unexpected(read.error());
    }
    return m_runs.isIdle().and_then([&] {
        return m_proposals.propose({.title = Text::tr("Terms from %1").arg(wanted.name),
                                    .reason = Text::tr("from a file"),
                                    .terms = read->terms,
                                    .sigmas = read->sigmas,
                                    .warnings = otherMountWarnings(*read, m_model.sheet())});
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
            m_proposals.pointsChanged();
        }
        if (m_points.countRestored()) {
            m_proposals.pointsRestored();
        }
    }
}

void CalibrationDesk::watchPoints()
{
    if (m_points.leaveOutOthers()) {
        m_proposals.pointsChanged();
    }
    if (m_points.noteTurns()) {
        m_proposals.renewPoints();
    }
}

}  // namespace boresight

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

// The fit of the same points against another model in force ends some ten millionths of a degree beside: less than half
// of the last place that is shown says nothing else.
constexpr Angle kSameFit = Angle::fromDegrees(0.0005);

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

// The axes may count from another place when the operator has answered.
void CalibrationDesk::noteTurns()
{
    const bool asked = std::ranges::any_of(kAxes, [this](Axis axis) { return m_control.isTurnAsked(axis); });
    if (asked && !m_book.points().empty()) {
        const bool first = !std::exchange(m_axesTold, m_clock.utc());
        if (first && m_by == ProposedBy::Points) {
            propose(m_by);
        }
    }
}

// Taken before the program, or the connection to the mount, was ended.
void CalibrationDesk::restorePoints()
{
    for (const calibration::CalibrationPoint& point : m_file.points()) {
        m_book.add(point);
    }
    if (m_book.points().empty()) {
        return;
    }
    m_log.add(Severity::Advisory, kTermsSource,
              Text::tr("%1 points that were taken before are here again; they count when both drives have told who "
                       "they are")
                  .arg(m_book.points().size()));
    m_pointsMount = m_file.pointsMount();
    m_book.setWaiting(true);
    m_book.fit(m_profile.pointing, m_model.known());
}

// Also the points that wait for both drives may count now.
void CalibrationDesk::noteDrives()
{
    if (m_mount.update()) {
        m_changed = true;
        leaveOutOtherPoints();
        countRestored();
    }
}

// Than what is in force; any turn of the azimuth offset is the same north.
bool CalibrationDesk::pointsSayOther() const
{
    if (!m_book.fitted()) {
        return false;
    }
    pointing::PointingTerms said = m_book.fitted()->terms;
    said.azimuthOffset = said.azimuthOffset.nearestTo(m_profile.pointing.azimuthOffset);
    return !isSame(said, m_profile.pointing, kSameFit);
}

void CalibrationDesk::countRestored()
{
    if (!m_book.isWaiting() || !m_mount.bothRead()) {
        return;
    }
    m_book.setWaiting(false);
    m_book.fit(m_profile.pointing, m_model.known());
    if (pointsSayOther() && m_by == ProposedBy::Nothing) {
        propose(ProposedBy::Points);
    }
}

// Where an axis shows 0° another drive does not know, nor another place where its north is. They stay in the list: the
// operator may have their reasons to use them all the same.
void CalibrationDesk::leaveOutOtherPoints()
{
    const calibration::MountDifference difference = calibration::difference(m_pointsMount, m_mount.today());
    if (difference == calibration::MountDifference::None || m_book.points().empty()) {
        return;
    }
    for (std::size_t i = 0; i < m_book.points().size(); ++i) {
        [[maybe_unused]] const Result<> out = m_book.use(i, false);
    }
    pointsChanged();
    const QString what = difference == calibration::MountDifference::OtherDrive
                             ? Text::tr("the points on the page Sun/Moon were taken with another drive")
                             : Text::tr("the points on the page Sun/Moon were taken at another site");
    m_control.alarms().raise(kOtherPoints, Severity::Warning,
                             {.what = what,
                              .action = Text::tr("None of them is used any more: nothing is found from them"),
                              .remedy = Text::tr("Drop them and take new ones; a point that still holds can be used "
                                                 "again on the page Model")});
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/kept_points.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/north/same_terms.h"
#include "core/units/direction_text.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

const QString kPointsSource = QStringLiteral("calibration");
// A fit of 60 points takes 15 ms of the control tick.
constexpr std::size_t kMostPoints = 60;
// A fit of the same points against another model in force differs by some ten millionths of a degree. A difference
// below half of the last shown digit is not a change.
constexpr Angle kSameFit = Angle::fromDegrees(0.0005);

// A value that is unknown today keeps its old content. Otherwise the points would belong to no mount and would never be
// left out.
calibration::RecordMount updated(calibration::RecordMount mount, const calibration::RecordMount& today)
{
    mount.azimuthDrive = today.azimuthDrive.empty() ? mount.azimuthDrive : today.azimuthDrive;
    mount.elevationDrive = today.elevationDrive.empty() ? mount.elevationDrive : today.elevationDrive;
    mount.site = today.site ? today.site : mount.site;
    return mount;
}

}  // namespace

KeptPoints::KeptPoints(StationControl& control, CalibrationFile& file, const MountIdentity& mount,
                       const ModelInForce& model, const Clock& clock, EventLog& log)
    : m_control(control), m_file(file), m_mount(mount), m_model(model), m_clock(clock), m_log(log)
{
    restore();
}

// Loads the points that were taken before the program or the connection to the mount was last ended.
void KeptPoints::restore()
{
    for (const calibration::CalibrationPoint& point : m_file.points()) {
        m_book.add(point);
    }
    if (m_book.points().empty()) {
        return;
    }
    m_log.add(Severity::Advisory, kPointsSource,
              Text::tr("%1 earlier points are loaded. They count when every drive has reported its identity")
                  .arg(m_book.points().size()));
    m_pointsMount = m_file.pointsMount();
    m_book.setWaiting(true);
    fit();
}

Result<> KeptPoints::hasRoom() const
{
    if (m_book.points().size() >= kMostPoints) {
        return failure(ErrorCode::Refused, Text::tr("There are already %1 points. Drop some.").arg(kMostPoints));
    }
    return {};
}

void KeptPoints::add(const NewPoint& point)
{
    m_book.add(
        {.axes = point.axes, .truth = point.truth, .sigma = point.sigma, .when = m_clock.utc(), .label = point.label});
    m_log.add(Severity::Advisory, kPointsSource,
              Text::tr("point %1: %2 at %3. The axes stand at %4.")
                  .arg(QString::number(m_book.points().size()), point.label, directionText(point.truth),
                       placeText(point.axes)));
    changed();
}

Result<> KeptPoints::drop(std::size_t index)
{
    return m_book.drop(index).map([this] { changed(); });
}

Result<> KeptPoints::use(std::size_t index, bool used)
{
    return m_book.use(index, used).map([this] { changed(); });
}

void KeptPoints::clear()
{
    m_book.clear();
    changed();
}

// Only the operator knows which of the two times was wrong.
void KeptPoints::clockWasSet()
{
    if (!m_book.points().empty()) {
        m_log.add(Severity::Warning, kPointsSource,
                  Text::tr("The clock of this computer was set. If the old time was wrong, drop the points of the Sun "
                           "and the Moon that were taken with it"));
    }
}

void KeptPoints::fit()
{
    m_book.fit(m_model.terms(), m_model.known());
}

void KeptPoints::changed()
{
    m_control.alarms().clear(alarmEntry("points.other-drive"));
    m_pointsMount = m_book.points().empty() ? calibration::RecordMount{} : updated(m_pointsMount, m_mount.today());
    m_file.keepPoints({.when = std::chrono::floor<std::chrono::milliseconds>(m_clock.utc()),
                       .title = QStringLiteral("Points"),
                       .mount = m_pointsMount,
                       .terms = {.before = m_model.terms(), .after = m_model.terms()},
                       .points = m_book.points()});
    fit();
}

// Another drive has its 0° elsewhere, and another site has north elsewhere. Such points stay in the list, so the
// operator can still use them.
bool KeptPoints::leaveOutOthers()
{
    const calibration::MountDifference difference = calibration::difference(m_pointsMount, m_mount.today());
    if (difference == calibration::MountDifference::None || m_book.points().empty()) {
        return false;
    }
    for (std::size_t i = 0; i < m_book.points().size(); ++i) {
        [[maybe_unused]] const Result<> out = m_book.use(i, false);
    }
    changed();
    m_control.alarms().raise(difference == calibration::MountDifference::OtherDrive ? alarmEntry("points.other-drive")
                                                                                    : alarmEntry("points.other-site"));
    return true;
}

bool KeptPoints::countRestored()
{
    if (!m_book.isWaiting() || !m_mount.bothRead()) {
        return false;
    }
    m_book.setWaiting(false);
    fit();
    return true;
}

// The operator's answer about the cable wrap may change where the axes count from.
bool KeptPoints::noteTurns()
{
    const bool asked = std::ranges::any_of(kAxes, [this](Axis axis) { return m_control.isTurnAsked(axis); });
    return asked && !m_book.points().empty() && !std::exchange(m_turnAsked, m_clock.utc());
}

// Azimuth offsets that differ by whole turns are the same north.
bool KeptPoints::contradictModel() const
{
    if (!m_book.fitted()) {
        return false;
    }
    pointing::PointingTerms fitted = m_book.fitted()->terms;
    fitted.azimuthOffset = fitted.azimuthOffset.nearestTo(m_model.terms().azimuthOffset);
    return !isSame(fitted, m_model.terms(), kSameFit);
}

bool KeptPoints::axesMayDiffer(std::span<const calibration::CalibrationPoint> points) const
{
    return m_turnAsked && std::ranges::any_of(points, [this](const calibration::CalibrationPoint& point) {
               return point.isUsed && point.when < *m_turnAsked;
           });
}

}  // namespace boresight

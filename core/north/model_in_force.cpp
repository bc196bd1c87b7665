// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/model_in_force.h"

#include "core/base/text.h"
#include "core/north/same_terms.h"

#include <QDateTime>

namespace boresight {
namespace {

QString dayOf(UtcTime when)
{
    const auto since = std::chrono::floor<std::chrono::seconds>(when.time_since_epoch());
    return QDateTime::fromSecsSinceEpoch(since.count(), Qt::UTC).toString(QStringLiteral("yyyy-MM-dd"));
}

}  // namespace

// The tilt that is known independently of the points, by the first `entries` of the history. Only a swing gives it, and
// a swing always changes the sensor. A tilt that was fitted to points is left out, because the same points would count
// twice. A tilt that was typed or read is left out, because its origin is unknown.
calibration::TermKnowledge ModelInForce::knownBy(std::size_t entries) const
{
    calibration::TermKnowledge known = calibration::TermKnowledge::usual();
    for (std::size_t i = entries; i > 0; --i) {
        const calibration::CalibrationRecord& record = m_file.history().entries()[i - 1];
        const auto& north = record.sigmas[calibration::indexOf(calibration::Term::TiltNorth)];
        const auto& east = record.sigmas[calibration::indexOf(calibration::Term::TiltEast)];
        if (record.points.empty() && record.sensor && north && east &&
            calibration::difference(record.mount, m_mount.today()) == calibration::MountDifference::None) {
            known.of(calibration::Term::TiltNorth) = {record.terms.after.tiltNorth, *north};
            known.of(calibration::Term::TiltEast) = {record.terms.after.tiltEast, *east};
            break;
        }
    }
    return known;
}

// The entry that brought the terms in force. Null if the terms were changed in another way since.
const calibration::CalibrationRecord* ModelInForce::entry() const
{
    const calibration::CalibrationHistory& history = m_file.history();
    if (!history.canUndo()) {
        return nullptr;
    }
    const calibration::CalibrationRecord& last = history.entries()[history.inForce() - 1];
    return isSame(last.terms.after, m_profile->pointing) ? &last : nullptr;
}

// The changes made in another way since the last applied entry. Empty: none.
QString ModelInForce::changedSince() const
{
    const calibration::CalibrationHistory& history = m_file.history();
    if (!history.canUndo() || entry() != nullptr) {
        return {};
    }
    return changeText(history.entries()[history.inForce() - 1].terms.after, m_profile->pointing);
}

// A term keeps its sigma as long as it keeps its value.
calibration::TermSheet ModelInForce::sheet() const
{
    calibration::TermSheet sheet{.mountName = m_profile->mount.name,
                                 .when = std::chrono::floor<std::chrono::seconds>(m_clock.utc()),
                                 .mount = m_mount.today(),
                                 .terms = m_profile->pointing,
                                 .sigmas = {}};
    const calibration::CalibrationHistory& history = m_file.history();
    for (const calibration::Term term : calibration::kAllTerms) {
        for (std::size_t i = history.inForce(); i > 0; --i) {
            const calibration::CalibrationRecord& record = history.entries()[i - 1];
            const Angle after = calibration::valueOf(record.terms.after, term);
            if (abs(after - calibration::valueOf(m_profile->pointing, term)) > kSameTerm) {
                break;
            }
            if (const auto& sigma = record.sigmas[calibration::indexOf(term)]) {
                sheet.sigmas[calibration::indexOf(term)] = sigma;
                break;
            }
        }
    }
    return sheet;
}

// How exactly Sun, Moon or landmarks gave the terms in force on this mount. A compass shows north and the zero of
// elevation only relative to its box, so it does not count. Sigmas from a text were not measured on this mount. If the
// points only confirmed a term, its value comes from an earlier swing, and the next swing is as good as that one. A
// term keeps its sigma as long as it keeps its value.
TermSigmas ModelInForce::toldByPoints() const
{
    TermSigmas told;
    const calibration::CalibrationHistory& history = m_file.history();
    for (const calibration::Term term : calibration::kAllTerms) {
        for (std::size_t i = history.inForce(); i > 0; --i) {
            const calibration::CalibrationRecord& record = history.entries()[i - 1];
            const Angle after = calibration::valueOf(record.terms.after, term);
            const bool otherMount =
                calibration::difference(record.mount, m_mount.today()) != calibration::MountDifference::None;
            if (otherMount || abs(after - calibration::valueOf(m_profile->pointing, term)) > kSameTerm) {
                break;
            }
            const auto& sigma = record.sigmas[calibration::indexOf(term)];
            if (sigma && !record.points.empty() && calibration::toldByPoints(*sigma, knownBy(i - 1).of(term))) {
                told[calibration::indexOf(term)] = sigma;
                break;
            }
        }
    }
    return told;
}

QString ModelInForce::otherMount() const
{
    const calibration::CalibrationRecord* const record = entry();
    if (record == nullptr) {
        return {};
    }
    const QString& what = record->title;
    const QString day = dayOf(record->when);
    switch (calibration::difference(record->mount, m_mount.today())) {
        case calibration::MountDifference::OtherDrive:
            return Text::tr("The pointing model in force (\"%1\", %2) was applied with another drive").arg(what, day);
        case calibration::MountDifference::OtherSite:
            return Text::tr("The pointing model in force (\"%1\", %2) was applied at another site").arg(what, day);
        case calibration::MountDifference::None:
            break;
    }
    return {};
}

}  // namespace boresight

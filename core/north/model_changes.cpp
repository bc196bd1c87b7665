// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/model_changes.h"

#include "core/base/text.h"
#include "core/cross_check/sensor_curve.h"
#include "core/north/same_terms.h"
#include "core/profile/setting.h"

namespace boresight {
namespace {

const QString kChangesSource = QStringLiteral("calibration");
const QString kOperator = QStringLiteral("operator");

}  // namespace

ModelChanges::ModelChanges(const StationControl& control, const profile::InForce& profile, CalibrationFile& file,
                           const MountIdentity& mount, const CalibrationRuns& runs, BodyFollower& follower,
                           const Clock& clock, EventLog& log)
    : m_control(control),
      m_profile(profile),
      m_file(file),
      m_mount(mount),
      m_runs(runs),
      m_follower(follower),
      m_clock(clock),
      m_log(log)
{}

// A new model does not move a mount that stands still, but it would lead a stream of directions elsewhere.
Result<> ModelChanges::mayChange() const
{
    return m_runs.isIdle().and_then([&]() -> Result<> {
        if (m_profile.wanted().bus != m_profile->bus) {
            return failure(
                ErrorCode::Refused,
                Text::tr("This calibration belongs to the mount at %2, but the bus of the profile is now %1. "
                         "Set the bus back, or press Reconnect and calibrate again.")
                    .arg(toQString(m_profile.wanted().bus), toQString(m_profile->bus)));
        }
        if (m_control.followsClient()) {
            return failure(
                ErrorCode::Refused,
                Text::tr(
                    "The mount tracks the target of a client, and the change would move the mount. Press Hold first."));
        }
        return m_follower.following() ? Result<>{} : m_control.mayChangePointing();  // a tracked body is released first
    });
}

// A new model moves horizon and keep-outs over the axes, and may so forbid the park position. Such a profile could not
// be loaded again.
Result<> ModelChanges::makesSense(const CalibrationChange& change) const
{
    for (profile::Profile wanted : {*m_profile, m_profile.wanted()}) {
        change.applyTo(wanted);
        const auto problems = profile::problemsOf(wanted);
        if (!problems.empty() && problems.front().key.starts_with("park.")) {
            return failure(ErrorCode::Refused, Text::tr("The park position would then be forbidden: %1. Set another "
                                                        "one first (tab Mount, Profile, \"park\"). Then apply.")
                                                   .arg(problems.front().text));
        }
        if (!problems.empty()) {
            return failure(ErrorCode::Refused,
                           Text::tr("The profile would then be inconsistent: %1. Change this setting first.")
                               .arg(profile::toText(problems.front())));
        }
    }
    return {};
}

Result<> ModelChanges::apply(const Proposal& proposal)
{
    const CalibrationChange change{.terms = proposal.terms, .sensor = proposal.sensor};
    return mayChange().and_then([&] { return makesSense(change); }).map([&] {
        calibration::CalibrationRecord record{.when = std::chrono::floor<std::chrono::milliseconds>(m_clock.utc()),
                                              .title = proposal.title,
                                              .mount = m_mount.today(),
                                              .terms = {.before = m_profile->pointing, .after = proposal.terms},
                                              .sigmas = proposal.sigmas,
                                              .points = proposal.points};
        if (proposal.sensor) {
            record.sensor = {.before = mountingOf(m_profile->sensor), .after = *proposal.sensor};
        }
        m_file.add(std::move(record));
        bringIntoForce(change, Text::tr("applies \"%1\": %2")
                                   .arg(proposal.title,
                                        changeText(m_profile->pointing, proposal.terms, proposal.sensor.has_value())));
        for (const QString& doubt : proposal.doubts) {
            m_log.add(Severity::Warning, kOperator, Text::tr("overrode this warning by Apply anyway: %1").arg(doubt));
        }
        for (const QString& warning : proposal.warnings) {
            m_log.add(Severity::Warning, kOperator, Text::tr("applied despite this warning: %1").arg(warning));
        }
    });
}

ModelChanges::Recall ModelChanges::undone() const
{
    const calibration::CalibrationHistory& history = m_file.history();
    const calibration::CalibrationRecord& record = history.entries()[history.inForce() - 1];
    Recall recall{.change = {.terms = record.terms.before}, .terms = record.terms.after};
    if (record.sensor) {
        recall.change.sensor = record.sensor->before;
        recall.sensor = record.sensor->after;
    }
    return recall;
}

ModelChanges::Recall ModelChanges::redone() const
{
    const calibration::CalibrationHistory& history = m_file.history();
    const calibration::CalibrationRecord& record = history.entries()[history.inForce()];
    Recall recall{.change = {.terms = record.terms.after}, .terms = record.terms.before};
    if (record.sensor) {
        recall.change.sensor = record.sensor->after;
        recall.sensor = record.sensor->before;
    }
    return recall;
}

Result<> ModelChanges::mayRecall(const Recall& recall) const
{
    return mayChange().and_then([&] { return stillInForce(recall.terms, recall.sensor); });
}

Result<> ModelChanges::mayUndo() const
{
    return m_file.history().canUndo() ? mayRecall(undone())
                                      : failure(ErrorCode::Refused, Text::tr("There is no calibration to undo."));
}

Result<> ModelChanges::mayRedo() const
{
    return m_file.history().canRedo() ? mayRecall(redone())
                                      : failure(ErrorCode::Refused, Text::tr("There is no calibration to redo."));
}

Result<> ModelChanges::undo()
{
    return mayUndo().and_then([this] { return makesSense(undone().change); }).map([this] {
        const calibration::CalibrationHistory& history = m_file.history();
        const CalibrationChange change = undone().change;
        warnOfOtherMount(history.entries()[history.inForce() - 1]);
        bringIntoForce(change, Text::tr("undoes \"%1\"").arg(m_file.undo().title));
    });
}

Result<> ModelChanges::redo()
{
    return mayRedo().and_then([this] { return makesSense(redone().change); }).map([this] {
        const calibration::CalibrationHistory& history = m_file.history();
        const CalibrationChange change = redone().change;
        warnOfOtherMount(history.entries()[history.inForce()]);
        bringIntoForce(change, Text::tr("applies \"%1\" again").arg(m_file.redo().title));
    });
}

// An edit that was made since then must not be lost silently.
Result<> ModelChanges::stillInForce(const pointing::PointingTerms& terms,
                                    const std::optional<calibration::SensorMounting>& sensor) const
{
    if (!isSame(terms, m_profile->pointing)) {
        return failure(ErrorCode::Refused, Text::tr("The pointing model was changed after that: %1. This change would "
                                                    "be lost. Undo it on the page Profile first, or type the terms.")
                                               .arg(changeText(terms, m_profile->pointing)));
    }
    if (sensor && !isSame(*sensor, mountingOf(m_profile->sensor))) {
        return failure(ErrorCode::Refused,
                       Text::tr("The mounting or the compass error of the sensor was changed after that. This change "
                                "would be lost. Undo it on the page Profile first."));
    }
    return {};
}

void ModelChanges::warnOfOtherMount(const calibration::CalibrationRecord& record)
{
    if (calibration::difference(record.mount, m_mount.today()) != calibration::MountDifference::None) {
        m_log.add(
            Severity::Warning, kChangesSource,
            Text::tr("\"%1\" was applied with another drive or at another site. Check north before you rely on it")
                .arg(record.title));
    }
}

void ModelChanges::bringIntoForce(const CalibrationChange& change, const QString& what)
{
    m_follower.end();  // with the new model the same body would be tracked elsewhere
    m_change = change;
    m_log.add(Severity::Advisory, kOperator, what);
}

}  // namespace boresight

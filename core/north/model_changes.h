// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_change.h"
#include "core/north/calibration_runs.h"
#include "core/north/proposals.h"

#include <optional>
#include <utility>

// Apply, Undo and Redo: decides whether a change of the model may come into force now, and writes it into the history.
// The change itself waits in take() for the caller who changes the profile. Moves nothing, but releases a tracked body.
// Station thread only.
namespace boresight {

class ModelChanges
{
public:
    // All arguments must outlive this object.
    ModelChanges(const StationControl& control, const profile::InForce& profile, CalibrationFile& file,
                 const MountIdentity& mount, const CalibrationRuns& runs, BodyFollower& follower, const Clock& clock,
                 EventLog& log);

    // Why the change is not possible now. The request also checks whether the profile would make sense. That takes too
    // long for every status.
    [[nodiscard]] Result<> mayChange() const;
    [[nodiscard]] Result<> mayUndo() const;
    [[nodiscard]] Result<> mayRedo() const;
    Result<> apply(const Proposal& proposal);
    Result<> undo();
    Result<> redo();
    // A change that must go into force at once.
    [[nodiscard]] std::optional<CalibrationChange> take() { return std::exchange(m_change, std::nullopt); }

private:
    // A record of the history that Undo or Redo uses: the values that come into force, and the values that must be in
    // force before that.
    struct Recall
    {
        CalibrationChange change;
        pointing::PointingTerms terms;
        std::optional<calibration::SensorMounting> sensor;
    };
    [[nodiscard]] Recall undone() const;  // call it only if there is one
    [[nodiscard]] Recall redone() const;
    [[nodiscard]] Result<> mayRecall(const Recall& recall) const;
    [[nodiscard]] Result<> makesSense(const CalibrationChange& change) const;
    [[nodiscard]] Result<> stillInForce(const pointing::PointingTerms& terms,
                                        const std::optional<calibration::SensorMounting>& sensor) const;
    void warnOfOtherMount(const calibration::CalibrationRecord& record);
    void bringIntoForce(const CalibrationChange& change, const QString& what);

    const StationControl& m_control;
    const profile::InForce& m_profile;
    CalibrationFile& m_file;
    const MountIdentity& m_mount;
    const CalibrationRuns& m_runs;
    BodyFollower& m_follower;
    const Clock& m_clock;
    EventLog& m_log;
    std::optional<CalibrationChange> m_change;
};

}  // namespace boresight

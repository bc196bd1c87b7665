// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_alarms.h"
#include "core/north/model_changes.h"
#include "core/north/point_taker.h"

#include <memory>

// The part of the status about the calibration: one immutable CalibrationStatus, made from the parts after a change and
// four times a second. Decides nothing. Station thread only.
namespace boresight {

// The parts of CalibrationDesk, for classes that only read them.
struct CalibrationParts
{
    const profile::InForce& profile;
    const CalibrationFile& file;
    const LiveSensor& sensor;
    const MountIdentity& mount;
    const ModelInForce& model;
    const KeptPoints& points;
    const Proposals& proposals;
    const CalibrationRuns& runs;
    const PointTaker& taker;
    const ModelChanges& changes;
    const CalibrationAlarms& alarms;
    BodyFollower& follower;  // computes where the bodies are, and when they rise and set
};

class CalibrationReport
{
public:
    // The parts and the clock must outlive it.
    CalibrationReport(const CalibrationParts& parts, const Clock& clock) : m_of(parts), m_clock(clock) {}

    // Call it when something has changed since the status was made.
    void expire() { m_expired = true; }
    [[nodiscard]] bool isDue() const;
    void renew();
    // Never null.
    [[nodiscard]] const std::shared_ptr<const CalibrationStatus>& status() const { return m_status; }

private:
    void fillBodies(CalibrationStatus& status) const;
    void fillPoints(CalibrationStatus& status) const;
    [[nodiscard]] std::optional<CalibrationProposal> proposalStatus() const;
    [[nodiscard]] std::vector<CalibrationHistoryEntry> historyEntries() const;

    CalibrationParts m_of;
    const Clock& m_clock;
    std::shared_ptr<const CalibrationStatus> m_status = std::make_shared<const CalibrationStatus>();
    SteadyTime m_made{};
    bool m_expired = true;
};

}  // namespace boresight

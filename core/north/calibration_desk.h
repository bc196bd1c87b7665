// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/north/calibration_report.h"

#include <memory>
#include <optional>

// Where the mount is calibrated: takes the operator's requests and calls its parts. CalibrationRuns leads the present
// run, KeptPoints keeps the points, Proposals holds what waits for Apply, ModelChanges puts it into force and
// CalibrationReport shows all of it. The desk stands beside StationControl and moves the mount only by requests to it,
// so limits, STOP, faults and authority apply as for everybody. Any other request for a motion ends a run at once. Only
// Apply, Undo and Redo change anything, and they do not move the mount. Station thread only.
namespace boresight {

class CalibrationDesk
{
public:
    // `file` keeps the history. All arguments must outlive the desk.
    CalibrationDesk(StationControl& control, const profile::InForce& profile, CalibrationFile& file, const Clock& clock,
                    EventLog& log);

    // Carries out a request that StationControl has admitted. Returns why, if it cannot.
    Result<> carryOut(const CalibrationRequest& request);
    // Uses the newest value of the sensor, if it is a new one.
    void take(const SensorStatus& sensor);
    // A value of the received power, and the state of the line that brings it.
    void take(const power::Value& value) { m_runs.take(value); }
    void show(const PowerLineStatus& line) { m_runs.show(line); }
    // Once per tick, before the tick of StationControl.
    void tick();
    // The clock of this computer was set. A tracked body and a cross scan end, because they would mix two times.
    void clockWasSet();
    // Call it after StationControl::profileChanged().
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // A change that must go into force at once, like a profile that the operator applies.
    [[nodiscard]] std::optional<CalibrationChange> takeChange() { return m_changes.take(); }

    // The proposal of the sensor that waits for Apply, with mounting and curve as they would be. A part that does not
    // change is filled with its present value.
    [[nodiscard]] std::optional<CalibrationChange> proposedOfSensor() const { return m_proposals.ofSensor(); }

    [[nodiscard]] const std::shared_ptr<const CalibrationStatus>& status() const { return m_report.status(); }
    // A run is moving the mount.
    [[nodiscard]] bool moves() const { return m_runs.moves(); }
    // Fills in the calibration's part of the status. While a run moves the mount, the state is CALIBRATE, whatever the
    // motion.
    void fill(StationStatus& status) const;

private:
    Result<> handle(const request::FollowBody& wanted);
    Result<> handle(const request::TakePoint& wanted);
    Result<> handle(const request::TakeKnownPoint& wanted);
    Result<> handle(const request::DropPoint& wanted);
    Result<> handle(const request::UsePoint& wanted);
    Result<> handle(const request::DropAllPoints& wanted);
    Result<> handle(const request::MeasureSensorOffset& wanted);
    Result<> handle(const request::PlanSwing& wanted);
    Result<> handle(const request::StartSwing& wanted);
    Result<> handle(const request::StartCrossScan& wanted);
    Result<> handle(const request::GivePower& wanted);
    Result<> handle(const request::ProposeTerms& wanted);
    Result<> handle(const request::ImportTerms& wanted);
    Result<> handle(const request::EndCalibration& wanted);
    Result<> handle(const request::ApplyCalibration& wanted);
    Result<> handle(const request::DiscardCalibration& wanted);
    Result<> handle(const request::UndoCalibration& wanted);
    Result<> handle(const request::RedoCalibration& wanted);

    [[nodiscard]] Result<> mayChangePoints() const;
    void useWhatEnded();
    void noteDrives();
    void watchPoints();

    const profile::InForce& m_profile;
    LiveSensor m_sensor;
    AxisObserver m_axes;
    MountIdentity m_mount;
    ModelInForce m_model;
    KeptPoints m_points;
    Proposals m_proposals;
    BodyFollower m_follower;
    CalibrationRuns m_runs;
    PointTaker m_taker;
    ModelChanges m_changes;
    CalibrationAlarms m_alarms;
    CalibrationReport m_report;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/north/calibration_report.h"

#include <memory>
#include <optional>

// Where the mount is calibrated: takes the operator's requests and calls its parts. CalibrationRuns leads what runs,
// KeptPoints keeps the points, Proposals holds what waits for Apply, ModelChanges brings it into force and
// CalibrationReport shows all of it. The desk stands beside StationControl and moves the mount only by asking it, so
// limits, STOP, faults and authority hold for it like for everybody. Whatever else is asked of the mount ends a run at
// once. Only Apply, Undo and Redo change anything, and they move nothing. Station thread.
namespace boresight {

class CalibrationDesk
{
public:
    // `file` keeps the history. All of them outlive the desk.
    CalibrationDesk(StationControl& control, const profile::InForce& profile, CalibrationFile& file, const Clock& clock,
                    EventLog& log);

    // What StationControl has admitted: done, or the reason why not.
    Result<> carryOut(const CalibrationRequest& request);
    // Its newest value, if that is a new one.
    void take(const SensorStatus& sensor);
    // From the line of the received power: what it says, and how it does.
    void take(const power::Value& value) { m_runs.take(value); }
    void show(const PowerLineStatus& line) { m_runs.show(line); }
    // Once per tick, before StationControl's.
    void tick();
    // After StationControl's.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // To be put into force at once, as a profile that the operator applies is.
    [[nodiscard]] std::optional<CalibrationChange> takeChange() { return m_changes.take(); }

    // The proposal of the sensor that waits for Apply, with its mounting and curve as they are or would be.
    [[nodiscard]] std::optional<CalibrationChange> proposedOfSensor() const { return m_proposals.ofSensor(); }

    [[nodiscard]] const std::shared_ptr<const CalibrationStatus>& status() const { return m_report.status(); }
    // A run moves the mount.
    [[nodiscard]] bool moves() const { return m_runs.moves(); }
    // Its part of the station's; while a run moves the mount the state is CALIBRATE, not what the motion is like.
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

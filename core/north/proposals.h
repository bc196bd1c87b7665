// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/north/calibration_change.h"
#include "core/north/calibration_proposal.h"
#include "core/north/kept_points.h"
#include "core/north/live_sensor.h"
#include "core/north/swing_run.h"

#include <cstdint>
#include <memory>
#include <optional>

// The proposal that waits for the operator's Apply: the last result or entry, compared with the model in force. A
// proposal that is made again gets a new number. Changes nothing on the mount. Station thread only.
namespace boresight {

class Proposals
{
public:
    // All arguments must outlive it. profileChanged() reports a new profile.
    Proposals(const profile::InForce& profile, const LiveSensor& sensor, const ModelInForce& model,
              const KeptPoints& points, EventLog& log);

    // Each replaces the previous proposal.
    void propose(const calibration::SensorOffset& offset);
    void propose(const SwungCompass& swung);  // an unusable compass is kept only to be shown
    Result<> propose(GivenTerms given);
    // The operator changed the points, or points were left out.
    void pointsChanged();
    // Points from an earlier run of the program count from this call on.
    void pointsRestored();
    // Makes the warnings of the proposal from points again.
    void renewPoints();
    void profileChanged(bool otherSensor);
    // Drops what the sensor found if its settings or the declination have changed since.
    void dropStale();
    Result<> discard(std::uint64_t number);

    enum class Next
    {
        Nothing,
        Points  // propose the points as soon as the change is in force
    };
    // Call it when a change comes into force.
    void clear(Next next);

    [[nodiscard]] const std::optional<Proposal>& current() const { return m_proposal; }
    // Refused if the proposal was replaced meanwhile: only the proposal that the operator has seen is applied.
    [[nodiscard]] Result<> isCurrent(std::uint64_t number) const;
    // Also refused if the proposal is unreliable and the operator has not overridden this.
    [[nodiscard]] Result<> mayApply(const request::ApplyCalibration& wanted) const;
    // The terms in force that stay, in words. Usually empty.
    [[nodiscard]] QString stays() const { return m_proposal ? m_proposal->stays : QString(); }
    // The term was found or entered. A term that points move only within its known error does not count. Only while
    // there is a proposal.
    [[nodiscard]] bool isFound(calibration::Term term) const;
    // The result of the sensor, with mounting and curve as they would be. A part that does not change has its present
    // value.
    [[nodiscard]] std::optional<CalibrationChange> ofSensor() const;
    [[nodiscard]] const std::optional<calibration::SensorOffset>& sensorOffset() const { return m_sensorOffset; }
    [[nodiscard]] const std::shared_ptr<const SwingOutcome>& swing() const { return m_swung.outcome; }

private:
    enum class From
    {
        Nothing,
        SensorOffset,
        Swing,
        Points,
        Entered  // typed, or read from a text
    };
    void proposeFrom(From from);
    [[nodiscard]] std::optional<Proposal> made() const;
    [[nodiscard]] Proposal madeOfSwing() const;
    [[nodiscard]] bool isOfSensor() const { return m_from == From::SensorOffset || m_from == From::Swing; }

    const profile::InForce& m_profile;
    const LiveSensor& m_sensor;
    const ModelInForce& m_model;
    const KeptPoints& m_points;
    EventLog& m_log;
    std::optional<calibration::SensorOffset> m_sensorOffset;
    SwungCompass m_swung;
    GivenTerms m_given;
    From m_from = From::Nothing;
    bool m_fitDiscarded = false;  // the proposal of the points was discarded, and their fit has not changed since
    Angle m_declination;          // in force when the north was found
    std::optional<Proposal> m_proposal;
    std::uint64_t m_count = 0;
};

}  // namespace boresight

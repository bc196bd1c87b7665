// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_change.h"
#include "core/north/calibration_proposal.h"
#include "core/north/kept_points.h"
#include "core/north/live_sensor.h"
#include "core/north/swing_run.h"

#include <cstdint>
#include <memory>
#include <optional>

// What waits for the operator's Apply: what was found or entered last, against the model in force. A proposal that is
// made again gets another number. Changes nothing of the mount. Station thread only.
namespace boresight {

class Proposals
{
public:
    // All of them outlive it. profileChanged() reports another profile.
    Proposals(const profile::InForce& profile, const LiveSensor& sensor, const ModelInForce& model,
              const KeptPoints& points, EventLog& log);

    // Each takes the place of what was proposed before.
    void propose(const calibration::SensorOffset& offset);
    void propose(const SwungCompass& swung);  // where the compass is of no use it is kept only, to be shown
    Result<> propose(GivenTerms given);
    // The operator changed the points, or they were left out.
    void pointsChanged();
    // Points of an earlier run of the program count from now on.
    void pointsRestored();
    // The proposal of the points gets its warnings again.
    void renewPoints();
    void profileChanged(bool otherSensor);
    // What the sensor found is dropped when its settings or the declination have changed since.
    void dropStale();
    Result<> discard(std::uint64_t number);

    enum class Next
    {
        Nothing,
        Points  // they are proposed as soon as the change is in force
    };
    // A change comes into force.
    void clear(Next next);

    [[nodiscard]] const std::optional<Proposal>& current() const { return m_proposal; }
    // Refused when another one is proposed by now: what was seen is what is applied.
    [[nodiscard]] Result<> isCurrent(std::uint64_t number) const;
    // Which of the terms in force stay, in words. Mostly empty.
    [[nodiscard]] QString stays() const { return m_proposal ? m_proposal->stays : QString(); }
    // The term was found out or entered. A term that points move only within what was known of it does not count.
    // Only while there is a proposal.
    [[nodiscard]] bool isFound(calibration::Term term) const;
    // What the sensor found, with its mounting and curve as they are or would be.
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
    bool m_fitDiscarded = false;  // what the points say, until they say otherwise
    Angle m_declination;          // that was in force when it was found
    std::optional<Proposal> m_proposal;
    std::uint64_t m_count = 0;
};

}  // namespace boresight

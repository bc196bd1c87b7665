// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/cross_check/ampere_link.h"
#include "core/cross_check/sensor_comparison.h"
#include "core/cross_check/site_declination.h"
#include "core/messages/sensor_status.h"
#include "core/mount/sensor_course.h"
#include "core/orientation/judge.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/profile/in_force.h"

// The orientation sensor as an independent check: judges its values, converts them to true directions and compares
// these with the axes. Reports the result in the status, by at most two alarms and a few lines of the log. It moves
// nothing and stops nothing. Pure except for the log; station thread.
namespace boresight {

// True angles that are young and calibrated enough to be evidence for a position of the axes.
struct SensorEvidence
{
    std::optional<Angle> azimuth;
    std::optional<Angle> elevation;
    std::optional<SensorCourse> course;  // how far the azimuth has turned, as long as it could be followed

    bool operator==(const SensorEvidence&) const = default;
};

class SensorWatch
{
public:
    // All arguments must outlive this object.
    SensorWatch(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms);

    // The mount does not have this axis, so the axis is not compared.
    void leaveOut(Axis axis);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // The declination of the site by the magnetic model, or why it is unknown. Empty: the model is still being read, or
    // there is no site. Used only if the profile names a file of a model. `model`: its name and years. `expiry`: a text
    // if the model ends soon or has ended.
    void setSiteDeclination(const std::optional<Result<Angle>>& declination, const QString& model = {},
                            const QString& expiry = {});

    // Another source, by its name. Empty: none.
    void begin(const QString& source);
    void show(const orientation::SourceStatus& status) { m_source.status = status; }
    void take(const orientation::Orientation& value);
    // A mounting and curve that wait for Apply; empty: none. As long as the sensor agrees with the axes by the
    // proposal, its disagreement by the settings in force is no alarm. It becomes an alarm when the proposal is
    // withdrawn. A difference that the proposal does not explain is an alarm at once.
    void setProposed(const std::optional<calibration::SensorMounting>& mounting);
    // Once per tick. `axes`: where the axes point, if known. `amperes`: sum of the absolute currents of both motors.
    // `proposed`: where the axes point by the proposal.
    void tick(const std::optional<SkyPointing>& axes, double amperes = 0.0,
              const std::optional<SkyPointing>& proposed = std::nullopt);

    [[nodiscard]] SensorStatus status() const;
    [[nodiscard]] SensorEvidence evidence() const;

private:
    // The source that is open, and its state.
    struct SourceInUse
    {
        QString name;  // empty: none is open
        orientation::SourceStatus status{};
        SteadyTime begun{};
        bool heard = false;   // values arrive, as the log last reported
        bool agreed = false;  // in azimuth, at least once
        bool unknownTold = false;
        std::uint64_t restartsTold = 0;
    };

    // The present content of the alarm about a difference.
    struct Told
    {
        bool stands = false;
        bool currentNamed = false;  // the current is named as the cause
        Axis axis = Axis::Azimuth;
        Angle apart;
    };

    [[nodiscard]] const profile::SensorSettings& settings() const { return m_profile->sensor; }
    // Why the azimuth of this value is no evidence. Empty: it is evidence.
    [[nodiscard]] QString doubtOf(const orientation::Orientation& value) const;
    [[nodiscard]] bool isYoung() const;
    [[nodiscard]] std::optional<SensorCourse> course(const orientation::Orientation& last) const;
    void compare(const orientation::Orientation& value);
    void correct();
    void correctProposed();
    void note(const orientation::Orientation& value);
    void tellPresence();
    // North was never found or set, and the sensor has never agreed with the axes. Then a difference in azimuth is
    // expected and no sign of a fault.
    [[nodiscard]] bool isNorthUnknown() const;
    // The difference lasts, is not expected, and is not explained by a proposal.
    [[nodiscard]] bool disagrees(Axis axis) const;
    [[nodiscard]] bool disagrees() const { return disagrees(Axis::Azimuth) || disagrees(Axis::Elevation); }
    void tellDisagreement();
    void tellNorth();
    void raiseAbsence();
    void raiseDisagreement();
    [[nodiscard]] Axis axisInDoubt() const;
    [[nodiscard]] bool hasChanged() const;
    [[nodiscard]] QString causes(Axis axis) const;

    const profile::InForce& m_profile;
    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    orientation::Judge m_judge;
    SiteDeclination m_site;
    SensorComparison m_inForce;
    std::optional<calibration::SensorMounting> m_proposed;
    SensorComparison m_afterApply;  // the comparison as it would be after Apply
    SourceInUse m_source;
    AmpereLink m_currentLink;
    // How often the course could not be followed, not including the breaks that the judge counts.
    std::uint64_t m_breaks = 0;
    Told m_told;
    std::optional<Angle> m_northTold;  // difference that the advice to set north shows
};

}  // namespace boresight

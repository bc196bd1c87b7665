// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/messages/sensor_status.h"
#include "core/mount/sensor_course.h"
#include "core/orientation/judge.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/profile/in_force.h"
#include "core/witness/ampere_link.h"
#include "core/witness/sensor_comparison.h"
#include "core/witness/site_declination.h"

// What the station makes of the orientation sensor: judges its values, turns them into true directions, compares these
// with the axes, and tells all that in the status, by at most two alarms and few lines of the log. It is a witness: it
// moves nothing and stops nothing. Pure but for the log; station thread.
namespace boresight {

// True angles that are young and calibrated enough to speak for a place of the axes.
struct SensorEvidence
{
    std::optional<Angle> azimuth;
    std::optional<Angle> elevation;
    std::optional<SensorCourse> course;  // how the azimuth went, while it can be followed

    bool operator==(const SensorEvidence&) const = default;
};

class SensorWatch
{
public:
    // All of them outlive it.
    SensorWatch(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms);

    // The mount has no such axis: it is not compared.
    void leaveOut(Axis axis);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Of the site by the magnetic model, or why it is not known; empty: the model is still read, or there is no site.
    // Counts while the profile names a file of one.
    // `model`: its name and years; `expiry`: that it ends or has ended.
    void setSiteDeclination(const std::optional<Result<Angle>>& declination, const QString& model = {},
                            const QString& expiry = {});

    // Another source from now on, by its name; empty: none.
    void begin(const QString& source);
    void show(const orientation::SourceStatus& status) { m_source.status = status; }
    void take(const orientation::Orientation& value);
    // A mounting and curve that were found and wait for Apply; empty: none. As long as the sensor agrees with the axes
    // by what is proposed, that it does not by what is in force is no alarm; it becomes one when it is not proposed any
    // more, and a difference that the proposal does not explain is one at once.
    void setProposed(const std::optional<calibration::SensorMounting>& mounting);
    // Once per tick; where the axes point, if that is known, and the current of both motors, without sign. `proposed`:
    // where they point by what is proposed.
    void tick(const std::optional<SkyPointing>& axes, double amperes = 0.0,
              const std::optional<SkyPointing>& proposed = std::nullopt);

    [[nodiscard]] SensorStatus status() const;
    [[nodiscard]] SensorEvidence evidence() const;

private:
    // The source that is open, and what was noticed of it.
    struct SourceInUse
    {
        QString name;  // empty: none is open
        orientation::SourceStatus status{};
        SteadyTime begun{};
        bool heard = false;   // as the log reported
        bool agreed = false;  // in azimuth, at least once
        bool unknownTold = false;
        std::uint64_t restartsTold = 0;
    };

    // What the alarm of a difference says now.
    struct Told
    {
        bool stands = false;
        bool currentNamed = false;  // as its cause
        Axis axis = Axis::Azimuth;
        Angle apart;
    };

    [[nodiscard]] const profile::SensorSettings& settings() const { return m_profile->sensor; }
    // Why its azimuth is no evidence; empty: it is.
    [[nodiscard]] QString doubtOf(const orientation::Orientation& value) const;
    [[nodiscard]] bool isYoung() const;
    [[nodiscard]] std::optional<SensorCourse> course(const orientation::Orientation& last) const;
    void compare(const orientation::Orientation& value);
    void correct();
    void correctProposed();
    void note(const orientation::Orientation& value);
    void tellPresence();
    // No north was found or set, and the sensor has never agreed with the axes: that they differ in azimuth is then
    // what has to be expected, and no sign that something is wrong.
    [[nodiscard]] bool isNorthUnknown() const;
    // For long enough, and neither expected nor explained by what waits for Apply.
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
    SensorComparison m_afterApply;  // what m_inForce would say after Apply
    SourceInUse m_source;
    AmpereLink m_currentLink;
    std::uint64_t m_breaks = 0;  // of the course, besides those that the judge sees
    Told m_told;
    std::optional<Angle> m_northTold;  // in the advice that north is not set
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/control/station_control.h"
#include "core/inputs/station_sensor.h"
#include "core/profile/in_force.h"
#include "core/recorder/pass_recorder.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <optional>

// Records each pass: from when the mount begins to follow a moving target until kAfter after its end. The target is
// tracked by Boresight or by the points of a client. Station thread.
namespace boresight {

class StationRecorder : public QObject
{
    Q_OBJECT

public:
    // A shorter break of the tracking does not end the recording.
    static constexpr std::chrono::seconds kAfter{10};

    // All arguments but the parent outlive this.
    StationRecorder(const QString& folder, const profile::InForce& profile, bool simulated, StationControl& control,
                    const StationSensor& sensor, const Clock& clock, const EventLog& log, QObject* parent);

    // Once per tick of the station, before the tick of the control: records the last tick of the control.
    void tick();

private:
    [[nodiscard]] std::optional<StationStatus> followed() const;
    void beginOrDescribe(const StationStatus& status);
    [[nodiscard]] std::uint64_t lastEntryBefore() const;
    void keepWithinLimits();
    void recordPlan(const StationStatus& status);
    void recordEvents(const StationStatus& status);
    void showTrouble(const QString& reason);

    const profile::InForce& m_profile;
    bool m_simulated;
    StationControl& m_control;
    const StationSensor& m_sensor;
    const Clock& m_clock;
    const EventLog& m_log;
    recorder::PassRecorder m_recorder;
    SteadyTime m_followed{};        // when the mount followed a target for the last time
    QString m_target;               // of the recording
    plan::SharedVariant m_plan;     // the newest in the recording
    QString m_point;                // the newest point of the client
    std::uint64_t m_lastEntry = 0;  // of the log, in the recording
};

// The folder for the recordings of a mount. A simulated mount has its own folder.
[[nodiscard]] QString recordingsPath(const QString& stateDir, const QString& mountName, bool simulated);

}  // namespace boresight

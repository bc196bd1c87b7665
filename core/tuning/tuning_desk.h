// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/control/station_control.h"
#include "core/messages/request.h"
#include "core/messages/tuning_status.h"
#include "core/tuning/tuning_run_state.h"

#include <memory>
#include <optional>

// Tunes the axes: moves one axis through a small run, measures how it responds, and keeps the figures before and after
// a change of the gains. It stands beside StationControl and moves the mount only by requests to it. So limits, STOP,
// faults and authority apply as for any client, and any other command to the mount ends a run at once. Each run needs
// its own request. Station thread.
namespace boresight {

class TuningDesk
{
public:
    // The references outlive the desk.
    TuningDesk(StationControl& control, const Clock& clock, EventLog& log);

    // Carries out a request that StationControl has admitted. Returns the reason if that is not possible. `drives`:
    // their present state. `calibrates`: a calibration moves the mount.
    Result<> carryOut(const TuningRequest& request, const std::optional<DrivesStatus>& drives, bool calibrates);
    // Once per tick, before the tick of StationControl.
    void tick();

    // Fills in its part of the station status, permissions included.
    void fill(StationStatus& status, bool calibrates) const;

private:
    [[nodiscard]] Result<> mayStart(Axis axis, bool calibrates) const;
    [[nodiscard]] TuningWay way(TuningRun run, Axis axis) const;
    Result<> start(const request::StartTuning& wanted, const std::optional<DrivesStatus>& drives, bool calibrates);
    void move(const TickSample& sample);
    [[nodiscard]] QString ending() const;
    void finish();
    void end(const QString& outcome, bool failed);
    void hold();
    void keep(TuningResult result);
    void renew();

    StationControl& m_control;
    const Clock& m_clock;
    EventLog& m_log;
    std::optional<TuningRunState> m_run;
    bool m_begun = false;                        // the control has accepted the first motion of the run
    std::vector<std::optional<double>> m_gains;  // of the axis of the run
    bool m_asFound = true;
    TuningStatus m_status;  // the plans and results
    std::shared_ptr<const TuningStatus> m_shown;
    SteadyTime m_renewed{};
};

}  // namespace boresight

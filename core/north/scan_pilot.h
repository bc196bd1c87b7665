// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/power_line_status.h"
#include "core/north/axis_observer.h"
#include "core/north/body_follower.h"
#include "core/north/run_end.h"
#include "core/north/scan_run.h"
#include "core/power/power_line.h"

#include <optional>

// Moves the beam through a cross scan of a body: points it beside the body place by place, passes the power to ScanRun,
// and notices what ends the scan. Station thread only.
namespace boresight {

class ScanPilot
{
public:
    // All arguments must outlive this object.
    ScanPilot(const StationControl& control, BodyFollower& follower, const AxisObserver& axes, const Clock& clock);

    [[nodiscard]] static Result<> isWidth(Angle width);
    // If it is refused before the first place, the scan does not run. If it fails at the first place, the scan runs and
    // the caller must end it.
    Result<> start(ephemeris::Body body, Angle width);
    [[nodiscard]] static Result<> isPower(double decibels);
    // The power that the operator has read. An error while the scan runs: the caller must end it.
    Result<> give(double decibels);
    // A value of the received power, and the state of the line that brings it.
    void take(const power::Value& value);
    void show(const PowerLineStatus& line) { m_line = line; }

    struct Step
    {
        bool read = false;  // a power was read at this place
        std::optional<RunEnd> end;
    };
    // Once per tick while a scan runs, after the axes were observed. Call end() after the scan has ended.
    [[nodiscard]] Step tick();
    void end();

    // Empty: no scan runs.
    [[nodiscard]] const std::optional<ScanRun>& run() const { return m_run; }
    // The last scan, from one start to the next.
    [[nodiscard]] const std::optional<calibration::CrossScan>& scanned() const { return m_scanned; }
    [[nodiscard]] const std::optional<double>& power() const { return m_power; }
    [[nodiscard]] const PowerLineStatus& line() const { return m_line; }

private:
    Result<> giveToRun(double decibels);
    [[nodiscard]] Result<> lookOn();
    [[nodiscard]] QString ending() const;
    [[nodiscard]] RunEnd finish(const AxisPosition& middle);

    const StationControl& m_control;
    BodyFollower& m_follower;
    const AxisObserver& m_axes;
    const Clock& m_clock;
    std::optional<ScanRun> m_run;
    ephemeris::Refraction m_before = ephemeris::Refraction::Light;  // the refraction before the scan
    std::optional<calibration::CrossScan> m_scanned;
    std::optional<double> m_power;  // dB, entered or read last
    PowerLineStatus m_line;
};

}  // namespace boresight

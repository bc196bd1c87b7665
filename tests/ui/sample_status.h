// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Statuses as a station would send them, for the tests of the window and for ui_demo.
namespace boresight::samples {

// Parked at az 0°, el 0°, both drives reply, one rotctld client, simulated.
[[nodiscard]] StationStatus idle();
// A pass across north from west to east, `seconds` after its start, of kPassLength.
[[nodiscard]] StationStatus tracking(double seconds);
inline constexpr double kPassLength = 600.0;

[[nodiscard]] StationStatus stopped();
[[nodiscard]] StationStatus faulted();
[[nodiscard]] StationStatus disconnected();
[[nodiscard]] StationStatus bounded();         // idle at 45° elevation, with a realistic region
[[nodiscard]] StationStatus routed();          // on the way around the mast of the same region
[[nodiscard]] StationStatus cableEnding();     // trimmed in mid-pass; the cable ends before the pass does; with presets
[[nodiscard]] StationStatus limited();         // the target is below the lowest elevation
[[nodiscard]] StationStatus operatorMoving();  // slewing to a go-to of the operator, who has control
[[nodiscard]] StationStatus factoryDrives();   // both drives with factory settings: nothing may move
[[nodiscard]] StationStatus reading();         // the drive check is running
[[nodiscard]] StationStatus released();        // the bus is released to other tools
[[nodiscard]] StationStatus proving();         // the crash-stop test moves the azimuth
// Boresight asks for the wrap of an axis. There are `places` candidates, `period` apart, a quarter of them below 45.1°
// (elevation 20°). The candidate at this angle is proposed if `proposed`.
[[nodiscard]] StationStatus asking(Axis axis, int places, Angle period, bool proposed);
// Fit to move, but the directions of the axes are not confirmed. Both axes are slightly above the horizon.
[[nodiscard]] StationStatus freshMount();
[[nodiscard]] StationStatus withAge(StationStatus status, std::chrono::milliseconds age);
[[nodiscard]] StationStatus withClients(StationStatus status, int count);
// A Gpredict whose targets jump has control, a logging program wants control, a third client only reads.
[[nodiscard]] StationStatus fighting();

// The ticks of such passes, 50 a second, from `begin` on for `seconds`, with gusts in the torque and a jolt every 97 s.
[[nodiscard]] std::vector<TickSample> ticks(SteadyTime begin, double seconds);

[[nodiscard]] StationUpdate update(const StationStatus& status);
[[nodiscard]] StationUpdate refusal(const StationStatus& status, std::uint64_t requestId, const char* reason);
[[nodiscard]] StationUpdate acceptance(const StationStatus& status, std::uint64_t requestId);
[[nodiscard]] LogEntry logEntry(std::uint64_t number, Severity severity, const QString& source, const QString& text);

}  // namespace boresight::samples

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

// Statuses as a station would send them, for the tests of the window and for ui_demo.
namespace boresight::samples {

// Parked at az 0°, el 0°, both drives answering, one rotctld client, simulated.
[[nodiscard]] StationStatus idle();
// A pass crossing north from west to east: `seconds` since its begin, of kPassLength.
[[nodiscard]] StationStatus tracking(double seconds);
inline constexpr double kPassLength = 600.0;

[[nodiscard]] StationStatus stopped();
[[nodiscard]] StationStatus faulted();
[[nodiscard]] StationStatus disconnected();
[[nodiscard]] StationStatus bounded();         // idle at 45° above the horizon, with a region as it is in life
[[nodiscard]] StationStatus routed();          // on the way around the mast of the same region
[[nodiscard]] StationStatus cableEnding();     // trimmed in mid-pass, the cable ends before the pass does; presets
[[nodiscard]] StationStatus limited();         // the target lies below the lowest elevation
[[nodiscard]] StationStatus operatorMoving();  // slewing to a go-to of the operator, who holds the control
[[nodiscard]] StationStatus factoryDrives();   // both drives as they come from the factory: nothing may move
[[nodiscard]] StationStatus reading();         // the survey runs
[[nodiscard]] StationStatus released();        // the bus is left to other tools
[[nodiscard]] StationStatus proving();         // the crash-stop proof moves the azimuth
// The turn of an axis is asked for: `places` each `period`, a quarter of them below 45.1° (elevation 20°),
// which is proposed if wanted.
[[nodiscard]] StationStatus asking(Axis axis, int places, Angle period, bool proposed);
// Fit to move, nobody has confirmed yet which way the axes turn; both stand a little above the horizon.
[[nodiscard]] StationStatus freshMount();
[[nodiscard]] StationStatus withAge(StationStatus status, std::chrono::milliseconds age);
[[nodiscard]] StationStatus withClients(StationStatus status, int count);
// A Gpredict that leaps leads, a logging program wants to, a third only reads.
[[nodiscard]] StationStatus fighting();

// The ticks of such passes, 50 a second, from `begin` on for `seconds`: gusts in the torque, a jolt each 97 s.
[[nodiscard]] std::vector<TickSample> ticks(SteadyTime begin, double seconds);

[[nodiscard]] StationUpdate update(const StationStatus& status);
[[nodiscard]] StationUpdate refusal(const StationStatus& status, std::uint64_t requestId, const char* reason);
[[nodiscard]] StationUpdate acceptance(const StationStatus& status, std::uint64_t requestId);
[[nodiscard]] LogEntry logEntry(std::uint64_t number, Severity severity, const QString& source, const QString& text);

}  // namespace boresight::samples

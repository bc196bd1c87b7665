// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// The changes to a profile when a mount is commissioned. Each function changes together all settings that depend on
// each other, so the profile stays consistent. Nothing here moves the mount. Pure.
namespace boresight::profile {

// The mount is reached by this bus, and its controllers answer under `ids`. If an id of the profile does not answer,
// the axes get `ids` in this order; only a motion shows which motor is which. A mount with one controller gets one id.
// Another bus means another mount: its directions are not confirmed. A real mount has no simulated sensor. If
// controllers are on this bus, axes of a rotator with a control box become axes of controllers.
void useBus(Profile& profile, const std::string& bus, std::span<const int> ids);

struct RotatorLine
{
    AxisDriver driver = AxisDriver::Rotctld;
    std::string bus;
    int baud = 9600;  // of the serial port
};

// The mount is a rotator with a control box, which moves to its targets by itself. An axis of a controller gets the
// travel and the speed of a common rotator, and the values of the previous mount are reset. If the mount is such a
// rotator already, only the way to reach it changes. Settings of Hamlib for another model are reset. A missing axis
// stays missing.
void useRotator(Profile& profile, const RotatorLine& line);

// True if useRotator() would reset values of a mount with controllers that were measured or entered: its zeros, travel
// or north.
[[nodiscard]] bool losesAMount(const Profile& profile, AxisDriver driver);

// True if bus.name is "simulated", as in a profile without that key. Then no real mount can be reached, and the
// simulated mount is used.
[[nodiscard]] bool namesNoBus(const Profile& profile);

// For a profile that was changed in a simulation and is saved to any file. The result names no real bus, so no real
// mount uses it as its own.
[[nodiscard]] Profile withoutBus(Profile profile);

// True for settings that are valid for one mount only: bus, directions of the axes, zeros, north, pointing model,
// mounting of the sensor and deviation of its compass.
[[nodiscard]] bool isOfOneMount(const std::string& key);

// Prepares a profile that names no real bus for a real mount. Such a file may contain values of the simulated mount, so
// all settings of one mount except the bus are reset. Travel and limits stay, because they may have been entered for
// the real mount. This is safe: the mount moves only a little before its directions are confirmed.
[[nodiscard]] Profile forRealMount(Profile profile);

// Exchanges the motors: the one set as azimuth turns the elevation. The directions must be confirmed again.
void swapMotors(Profile& profile);

// Reverses the direction of an axis. If its present reading is known, the axis keeps that reading. The directions must
// be confirmed again.
void reverse(Profile& profile, Axis axis, const std::optional<Angle>& reading);

// Sets the travel of the axis. Limits of operation and a park position outside the travel are moved inside.
void setTravel(Profile& profile, Axis axis, const TravelRange& travel);

// How travel, limits of operation and park change when an axis gets another zero.
enum class Ends
{
    StayOnTheMount,  // cable and stops keep their physical places, so their numbers change
    KeepTheirNumbers
};

// Changes the zero of the axis, so that the present reading `reading` becomes `truth`.
void setReading(Profile& profile, Axis axis, Angle reading, Angle truth, Ends ends);

// With the axes at `axes` the beam points to `trueAzimuth`. Only the setting of north changes, not the axis angles.
void setNorth(Profile& profile, const AxisPosition& axes, Angle trueAzimuth);

}  // namespace boresight::profile

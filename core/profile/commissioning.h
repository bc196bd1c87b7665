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

// The mount is reached by this bus, whose controllers answer under `ids`. Two ids that are not the profile's become
// azimuth and elevation in this order; which is which is seen when they move. A mount with one controller takes one id.
// Another bus is another mount: its directions are not confirmed. A real mount has no simulated sensor. Axes that a
// rotator with a box turned are turned by controllers then, if this is their bus.
void useBus(Profile& profile, const std::string& bus, std::span<const int> ids);

struct RotatorLine
{
    AxisDriver driver = AxisDriver::Rotctld;
    std::string bus;
    int baud = 9600;  // of a serial port
};

// The mount is a rotator that runs to its targets by itself. An axis that controllers turned gets the travel and the
// speed of a usual rotator, and counts as its box does. What belonged to the mount before is forgotten. A rotator that
// is reached in another way keeps all but that. A missing axis stays missing.
void useRotator(Profile& profile, const RotatorLine& line);

// True if useRotator() would discard values of a mount with controllers, found or typed: its zeros, travel or north.
[[nodiscard]] bool losesAMount(const Profile& profile, AxisDriver driver);

// bus.name is "simulated", as in a profile without that key. There is no real mount to be reached, so the simulated one
// runs in its place.
[[nodiscard]] bool namesNoBus(const Profile& profile);

// For a profile that was changed in a simulation and is saved to any file. The result names no real bus, so no real
// mount uses it as its own.
[[nodiscard]] Profile withoutBus(Profile profile);

// True for settings that are valid for one mount only: bus, directions of the axes, zeros, north and pointing model,
// mounting of the sensor and deviation of its compass.
[[nodiscard]] bool isOfOneMount(const std::string& key);

// Of a profile that names no real bus: what a real mount takes from it. An older version kept there what was found of
// the simulated mount, so all that belongs to one mount is as if never found. Travel and limits stay: they may have
// been typed for the real mount, and nothing moves farther than a little before the directions are confirmed. The bus
// stays.
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

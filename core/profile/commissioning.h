// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// The changes of a profile that commissioning a mount consists of, each as one act: what hangs together is changed
// together, so that the profile goes on making sense. Nothing here moves anything. Pure.
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

// useRotator() would forget what was found or typed for a mount with controllers: its zeros, travel or north.
[[nodiscard]] bool losesAMount(const Profile& profile, AxisDriver driver);

// bus.name is "simulated", as in a profile without that key. There is no real mount to be reached, so the simulated one
// runs in its place.
[[nodiscard]] bool namesNoBus(const Profile& profile);

// Of a profile that was changed in a simulation, for a file that may go anywhere: no real mount takes it for its own.
[[nodiscard]] Profile withoutBus(Profile profile);

// Belongs to one mount alone: its bus, which way its axes turn, its zeros, north and pointing model, how the sensor is
// mounted and what iron does to its compass.
[[nodiscard]] bool isOfOneMount(const std::string& key);

// Of a profile that names no real bus: what a real mount takes from it. An older version kept there what was found of
// the simulated mount, so all that belongs to one mount is as if never found. Travel and limits stay: they may have
// been typed for the real mount, and nothing moves farther than a little before the directions are confirmed. The bus
// stays.
[[nodiscard]] Profile forRealMount(Profile profile);

// The motor that was taken for the azimuth's is the elevation's. Directions are to be confirmed again.
void swapMotors(Profile& profile);

// The motor turns the axis the other way than the profile says. The axis goes on reading what it reads now, if that is
// known. Directions are to be confirmed again.
void reverse(Profile& profile, Axis axis, const std::optional<Angle>& reading);

// The axis may go from here to there. What lay outside (limits of operation, park) is brought inside.
void setTravel(Profile& profile, Axis axis, const TravelRange& travel);

// What becomes of travel, limits of operation and park when the angles of an axis get another zero.
enum class Ends
{
    StayOnTheMount,  // cable and stops are where they were: their numbers change
    KeepTheirNumbers
};

// What the axis reads now is really `truth`.
void setReading(Profile& profile, Axis axis, Angle reading, Angle truth, Ends ends);

// With its axes here the beam really points to this azimuth. Only where north is changes: no angle of an axis does.
void setNorth(Profile& profile, const AxisPosition& axes, Angle trueAzimuth);

}  // namespace boresight::profile

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
// azimuth and elevation in this order; which is which is seen when they move. Another bus is another mount: its
// directions are not confirmed; and the simulated one is left.
void useBus(Profile& profile, const std::string& bus, std::span<const int> ids);

[[nodiscard]] bool isSimulated(const Profile& profile);

// Where north is, how the axes lean, how the sensor is mounted, what iron does to its compass: of one mount alone.
[[nodiscard]] bool isFoundByCalibrating(const std::string& key);
// The same, and where the encoders have their zero.
[[nodiscard]] bool isFoundOfOneMount(const std::string& key);
// Anything of this is in the profile.
[[nodiscard]] bool isAnythingFound(const Profile& profile);

// The one place where a mount stops being the simulated one; every way in which the bus of a profile changes goes
// through here. `changed` was `before`. If it left the simulated mount, then what was found of that one, unless it was
// changed too, is as if never found, its sensor is gone, and which way the axes turn is to be confirmed; the keys of
// all this are returned. Travel and limits stay: they may have been typed for the real mount, and nothing moves farther
// than a little before the directions are confirmed.
std::vector<std::string> leaveSimulatedMount(Profile& changed, const Profile& before);

// Of a profile that `after` was made of: the keys that leaveSimulatedMount() has set back, and still are.
[[nodiscard]] std::vector<std::string> leftWithSimulatedMount(const Profile& before, const Profile& after);

// As takeOver(), from a whole profile, such as a file or a version: what was found of a mount comes with its bus, all
// of it, and none of the simulated one's without.
void takeOverMount(Profile& into, const Profile& from, std::vector<std::string> keys);

// The motor that was taken for the azimuth's is the elevation's. Directions are to be confirmed anew.
void swapMotors(Profile& profile);

// The motor turns the axis the other way than the profile says. The axis goes on reading what it reads now, if that is
// known. Directions are to be confirmed anew.
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

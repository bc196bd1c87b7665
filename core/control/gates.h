// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/messages/station_status.h"

#include <chrono>
#include <cstdint>

// Decides for every source of motion whether the mount may move now. Each gate returns the reason of a refusal in
// words. Reads the parts of the control and changes nothing. Station thread only.
namespace boresight {

// A measured position older than this does not count.
inline constexpr std::chrono::seconds kOldestPosition{1};

class Gates
{
public:
    explicit Gates(const ControlParts& parts) : m_of(parts) {}

    // This source may command the mount now: neither the operator nor another client has control instead.
    [[nodiscard]] Result<> mayCommand(const Source& source) const;
    // A shell of this computer may move the mount when a client of it could. No client loses control by this.
    [[nodiscard]] Result<> mayShellCommand() const;
    // The mount is armed, no crash-stop test is running, and the wind permits the motion.
    [[nodiscard]] Result<> mayMove(const Source& source) const;
    [[nodiscard]] Result<> mayHold(const Source& source) const;   // the mount moves, or it could be moved
    [[nodiscard]] Result<> mayLeavePark() const;                  // the mount is not kept parked by the wind
    [[nodiscard]] Result<> mayPoint(const Source& source) const;  // to any place
    [[nodiscard]] Result<> mayPark(const Source& source) const;   // to the park position, also in a strong wind
    [[nodiscard]] Result<> mayJog(const AxisRates& rates, const Source& source) const;  // where necessary only slowly
    [[nodiscard]] Result<> axesPlaced() const;  // on known wraps and not far outside the travel
    // While the clock is not trusted, only the operator may jog a mount in the Sun's band, and slowly.
    [[nodiscard]] Result<> mayLeaveSunBand(const AxisRates& rates, const Source& source) const;
    [[nodiscard]] bool isInSunBand(const AxisPosition& place) const;
    [[nodiscard]] Result<> mayFaceSun() const;     // the profile permits pointing the beam at the Sun
    [[nodiscard]] AngularRate fastestJog() const;  // by hand, in any direction, as permitted now
    // The measured axis is not at this end of its travel. While the wrap is unknown, the gate is open.
    [[nodiscard]] Result<> isWayOn(Axis axis, bool upwards) const;
    [[nodiscard]] Result<> mayBeAt(const AxisPosition& place) const;  // inside travel, limits, horizon and keep-outs
    [[nodiscard]] AxisPosition home() const;
    [[nodiscard]] AxisPosition park() const;             // in a strong wind: the stow position
    [[nodiscard]] bool isAtPark() const;                 // as measured
    [[nodiscard]] Result<AxisPosition> unwound() const;  // the same direction with the azimuth cable wound least
    // A client may send 95° for the same direction behind the zenith. For an operator 95° is a typing error, so it is
    // refused unless the axis can go there.
    [[nodiscard]] Result<> isElevation(Angle elevation) const;
    [[nodiscard]] Result<> hasAxis(Axis axis) const;
    [[nodiscard]] Result<> isPlaced(Axis axis) const;  // its wrap is known
    [[nodiscard]] Result<> isFresh(Axis axis) const;   // its position is not older than kOldestPosition

    [[nodiscard]] Result<> mayResetStop() const;
    [[nodiscard]] Result<> mayHoldAtEnd() const;  // wait at the cable end instead of unwrapping
    [[nodiscard]] Result<> mayClearTrim() const;  // there is a trim
    [[nodiscard]] Result<> mayGiveControl() const;
    [[nodiscard]] Result<> mayGiveControlTo(std::uint64_t clientId) const;
    // A change of the pointing model would not change the running motion.
    [[nodiscard]] Result<> mayChangePointing() const;
    // The antenna may be changed. A target that Boresight tracks is then tracked with the new beam.
    [[nodiscard]] Result<> mayUseAntenna() const;
    // The profile `after` may be applied, although it gives the beam other terms or selects another antenna.
    [[nodiscard]] Result<> mayTurnBeam(const profile::Profile& after) const;
    [[nodiscard]] Result<> usesMainAntenna() const;

    // 1 or -1: the axis is above or below its travel by more than the bounds of the drives. 0: not, or unknown.
    [[nodiscard]] int farOutside(Axis axis) const;

private:
    [[nodiscard]] Result<> isWindFine() const;
    [[nodiscard]] Result<> mayMoveInWind(const Source& source) const;
    [[nodiscard]] Result<> mayJogSlowly(const AxisRates& rates) const;
    [[nodiscard]] Result<> insideTravel() const;

    ControlParts m_of;
};

}  // namespace boresight

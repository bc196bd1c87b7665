// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/messages/station_status.h"

#include <chrono>
#include <cstdint>

// Whether the mount may move now, for every source of motion. Each gate returns the reason of a refusal in words.
// Reads the parts of the control and changes nothing. Station thread only.
namespace boresight {

// A measured position older than this does not count.
inline constexpr std::chrono::seconds kOldestPosition{1};

class Gates
{
public:
    explicit Gates(const ControlParts& parts) : m_of(parts) {}

    // Whether this source has the control, as far as the operator and the other clients are concerned.
    [[nodiscard]] Result<> mayCommand(const Source& source) const;
    // A shell of this computer may move the mount as a client could: no client loses the control by it.
    [[nodiscard]] Result<> mayShellCommand() const;
    // Armed, no proof is running, and the wind permits it.
    [[nodiscard]] Result<> mayMove(const Source& source) const;
    // Something goes on that Hold ends, or could begin.
    [[nodiscard]] Result<> mayHold(const Source& source) const;
    [[nodiscard]] Result<> mayPoint(const Source& source) const;                        // anywhere
    [[nodiscard]] Result<> mayPark(const Source& source) const;                         // also in a strong wind
    [[nodiscard]] Result<> mayJog(const AxisRates& rates, const Source& source) const;  // or is jogged slowly
    [[nodiscard]] Result<> axesPlaced() const;  // each on a wrap that is known, and not far outside its travel
    // While the clock is doubted: from where the Sun can be only the operator's slow jog leads out.
    [[nodiscard]] Result<> mayLeaveSunBand(const AxisRates& rates, const Source& source) const;
    [[nodiscard]] bool isInSunBand(const AxisPosition& place) const;
    // The profile lets the beam at the Sun itself.
    [[nodiscard]] Result<> mayFaceSun() const;
    // At most this fast by hand, whatever the direction.
    [[nodiscard]] AngularRate fastestJog() const;
    // The axis is not at the end of its travel, as measured. On an unknown wrap the angles do not show that.
    [[nodiscard]] Result<> isWayOn(Axis axis, bool upwards) const;
    [[nodiscard]] Result<> mayBeAt(const AxisPosition& place) const;  // travel, limits, horizon and keep-outs
    [[nodiscard]] AxisPosition home() const;
    [[nodiscard]] AxisPosition park() const;  // in a strong wind the place for that
    [[nodiscard]] bool isAtPark() const;      // the axes stand there, as measured
    // The same direction, where the azimuth cable is wound least.
    [[nodiscard]] Result<AxisPosition> unwound() const;
    // To a client 95° is the equal direction behind the zenith; an operator who asks for it has slipped.
    [[nodiscard]] Result<> isElevation(Angle elevation) const;
    [[nodiscard]] Result<> hasAxis(Axis axis) const;
    [[nodiscard]] Result<> isFresh(Axis axis) const;  // measured within kOldestPosition
    // It stands still at an angle that is known and fresh, which may be given another number.
    [[nodiscard]] Result<> maySet(Axis axis) const;

    [[nodiscard]] Result<> drivesRest() const;  // for what is done to the drives themselves
    [[nodiscard]] Result<> mayReadDrives() const;
    [[nodiscard]] Result<> mayFixDrives() const;
    [[nodiscard]] Result<> mayChangeBoards() const;  // an id or a gear; also where not every drive answers
    [[nodiscard]] Result<> maySwitchOff() const;
    [[nodiscard]] Result<> maySwitchOff(Axis axis) const;
    [[nodiscard]] Result<> mayLeaveBus() const;
    [[nodiscard]] Result<> mayTune(Axis axis) const;              // its gains, while it stands
    [[nodiscard]] Result<> mayTuneOff(Axis axis) const;           // and those for which the drives must be off
    [[nodiscard]] Result<> hasService() const;                    // something can be done to the mount itself
    [[nodiscard]] Result<> mayProve(const Source& source) const;  // how the axes stop
    [[nodiscard]] Result<> mayEndProof() const;
    [[nodiscard]] Result<> mayTakeBus() const;
    [[nodiscard]] Result<> mayChooseTurn(Axis axis) const;  // answer which wrap it is on
    [[nodiscard]] Result<> mayResetStop() const;
    [[nodiscard]] Result<> mayHoldAtEnd() const;  // instead of the unwrapping that is ahead
    [[nodiscard]] Result<> mayClearTrim() const;  // there is one
    [[nodiscard]] Result<> mayGiveControl() const;
    [[nodiscard]] Result<> mayGiveControlTo(std::uint64_t clientId) const;
    // Whether other terms of the pointing model would leave the motion what it is.
    [[nodiscard]] Result<> mayChangePointing() const;
    // What Boresight tracks itself goes on with the beam of the other antenna.
    [[nodiscard]] Result<> mayUseAntenna() const;
    // Whether the beam in use, by its terms or by another choice of the antenna, may be that of this profile.
    [[nodiscard]] Result<> mayTurnBeam(const profile::Profile& after) const;
    [[nodiscard]] Result<> usesMainAntenna() const;

    // Outside its travel by more than the drives' own bounds allow: 1 above, -1 below; 0 inside, or nobody knows.
    [[nodiscard]] int farOutside(Axis axis) const;

private:
    [[nodiscard]] Result<> isWindFine() const;
    [[nodiscard]] Result<> mayMoveInWind(const Source& source) const;
    [[nodiscard]] Result<> isPlaced(Axis axis) const;
    [[nodiscard]] Result<> drivesAnswer() const;
    [[nodiscard]] Result<> axesStand() const;  // as measured
    [[nodiscard]] Result<> mayJogSlowly(const AxisRates& rates) const;
    [[nodiscard]] Result<> insideTravel() const;

    ControlParts m_of;
};

}  // namespace boresight

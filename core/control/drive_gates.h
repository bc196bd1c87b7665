// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/gates.h"

// Decides whether work on the drives themselves is permitted now: settings, gains, boards, bus, wraps, the crash-stop
// test. Each gate returns the reason of a refusal in words. Changes nothing. Station thread only.
namespace boresight {

class DriveGates
{
public:
    explicit DriveGates(const ControlParts& parts) : m_of(parts), m_gates(parts) {}

    // The angle of the axis may be set to another number: the axis stands still, and its angle is known and fresh.
    [[nodiscard]] Result<> maySet(Axis axis) const;
    [[nodiscard]] Result<> drivesRest() const;  // required for work on the drives themselves
    [[nodiscard]] Result<> axesStand() const;   // as measured
    [[nodiscard]] Result<> mayReadDrives() const;
    [[nodiscard]] Result<> mayFixDrives() const;
    [[nodiscard]] Result<> mayChangeBoards() const;  // an id or a gear ratio; some drives may be silent
    [[nodiscard]] Result<> maySwitchOff() const;
    [[nodiscard]] Result<> maySwitchOff(Axis axis) const;
    [[nodiscard]] Result<> mayLeaveBus() const;
    [[nodiscard]] Result<> mayTune(Axis axis) const;              // those gains that a drive takes while it is on
    [[nodiscard]] Result<> mayTuneOff(Axis axis) const;           // those gains that need the drive off
    [[nodiscard]] Result<> mayProve(const Source& source) const;  // run the crash-stop test
    [[nodiscard]] Result<> mayEndProof() const;
    [[nodiscard]] Result<> mayTakeBus() const;
    [[nodiscard]] Result<> mayChooseTurn(Axis axis) const;  // the operator may answer which wrap the axis is on

private:
    [[nodiscard]] Result<> hasService() const;  // the mount has functions for its drives
    [[nodiscard]] Result<> drivesAnswer() const;

    ControlParts m_of;
    Gates m_gates;
};

}  // namespace boresight

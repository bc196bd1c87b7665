// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/bus_scan.h"
#include "core/drive_check/findings.h"
#include "core/messages/drive_identity.h"
#include "core/profile/profile.h"

#include <array>
#include <span>
#include <vector>

// Compares the boards that a scan found with those that the profile and the journal expect. Reports missing, doubled,
// interchanged, replaced, unknown and additional boards. Pure.
namespace boresight::drive_check {

// The UUIDs of the boards in the journal, azimuth and elevation. Empty for an axis without a known board.
using KnownBoards = std::array<QString, 2>;

// `axes`: the axes that have a drive. A board with the id of an axis without a drive counts as unknown.
[[nodiscard]] std::vector<Finding> identityFindings(const profile::Profile& profile, const KnownBoards& known,
                                                    std::span<const FoundController> found, AxisSet axes = kAxes);

// The only readable board with that id. Null if there is none, or more than one.
[[nodiscard]] const FoundController* onlyBoard(std::span<const FoundController> found, int id);

[[nodiscard]] DriveIdentity identityOf(const FoundController& controller);

}  // namespace boresight::drive_check

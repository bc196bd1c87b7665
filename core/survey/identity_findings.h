// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drive_identity.h"
#include "core/profile/profile.h"
#include "core/survey/bus_scan.h"
#include "core/survey/findings.h"

#include <array>
#include <span>
#include <vector>

// Whether the boards that a scan found are those the profile and the memory expect: each missing, doubled, swapped,
// replaced, unknown or additional one in words. Pure.
namespace boresight::survey {

// The boards that the memory knows, by their UUID; empty where it knows none. Azimuth, elevation.
using KnownBoards = std::array<QString, 2>;

// `axes`: those that have a drive here. A board under the id of another one is as strange as any.
[[nodiscard]] std::vector<Finding> identityFindings(const profile::Profile& profile, const KnownBoards& known,
                                                    std::span<const FoundController> found, AxisSet axes = kAxes);

// The one readable board under that id; null if there is none, or more than one.
[[nodiscard]] const FoundController* onlyBoard(std::span<const FoundController> found, int id);

[[nodiscard]] DriveIdentity identityOf(const FoundController& controller);

}  // namespace boresight::survey

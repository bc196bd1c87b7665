// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"

// The GS-232 rotators for the list of mount kinds.
namespace boresight::gs232 {

// The simulated rotator stays the same when the mount is connected again.
[[nodiscard]] MountKind gs232Rotators();
// The entry in the setup guide.
[[nodiscard]] RotatorOffer gs232Offer();

}  // namespace boresight::gs232

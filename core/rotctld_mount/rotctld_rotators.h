// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"

// The rotators of Hamlib for the list of mount kinds.
namespace boresight::rotctl {

// The simulated rotator stays the same when the mount is connected again.
[[nodiscard]] MountKind rotctldRotators();
// The entries in the setup guide.
[[nodiscard]] RotatorOffer rotctldOffer();
[[nodiscard]] RotatorOffer hamlibOffer();

}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"

// What Hamlib drives, as the wiring lists it.
namespace boresight::rotctl {

// A simulated one stays the same one when the mount is connected again.
[[nodiscard]] MountKind rotctldRotators();
// As the guide offers them.
[[nodiscard]] RotatorOffer rotctldOffer();
[[nodiscard]] RotatorOffer hamlibOffer();

}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_offer.h"
#include "core/mount/mount_kind.h"

// The GS-232 rotators, as the wiring lists them.
namespace boresight::gs232 {

// A simulated one stays the same one when the mount is connected again.
[[nodiscard]] MountKind gs232Rotators();
// As the guide offers them.
[[nodiscard]] RotatorOffer gs232Offer();

}  // namespace boresight::gs232

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"
#include "core/profile/profile.h"

#include <QString>

namespace boresight::mqtt {

// The broker of the profile. `ownId` is the name of the connection where the profile has no client id.
[[nodiscard]] Broker brokerOf(const profile::BrokerSettings& settings, const QString& ownId);

}  // namespace boresight::mqtt

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/contacts/output_name.h"
#include "core/outputs/output.h"
#include "core/profile/profile.h"

#include <QString>

#include <memory>

namespace boresight::outputs {

// The output of this name. Null for OutputKind::None, and for a pin of the mount, which only the mount can make. `use`
// makes the MQTT client id of the profile unique, because a broker disconnects the first of two clients with the same
// id. `clock` outlives the output, and any thread may read it.
[[nodiscard]] std::unique_ptr<Output> makeOutput(const contacts::OutputName& name, const QString& use,
                                                 const profile::BrokerSettings& broker, const Clock& clock);

}  // namespace boresight::outputs

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

// Why something can not be done about a client now, in words for a tooltip; empty when it can. No client: none is
// selected.
namespace boresight::ui {

[[nodiscard]] QString whyNoClient(const ClientStatus* client);
[[nodiscard]] QString whyNoGiving(const StationStatus& status, const ClientStatus* client);

}  // namespace boresight::ui

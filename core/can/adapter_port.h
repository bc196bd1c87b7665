// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/serial/stable_port.h"

#include <QString>

// The serial port of a CAN adapter of mjbots.
namespace boresight {

// True for both adapters that mjbots makes, and for later ones with its name.
[[nodiscard]] bool isAdapterName(const QString& name);

// A spare adapter may replace the stored one.
[[nodiscard]] StablePort adapterPort(const QString& path, const QString& namesFolder = kStableNames);

// Like checkSerialPort(). The remedy for a missing permission is the udev rule of the adapter.
[[nodiscard]] Result<> checkAdapterPort(const QString& device);

}  // namespace boresight

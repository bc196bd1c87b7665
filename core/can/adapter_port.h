// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/serial/stable_port.h"

#include <QString>

// The serial port of a CAN adapter of mjbots.
namespace boresight {

// Of both adapters that mjbots makes, and of those it may make later.
[[nodiscard]] bool isAdapterName(const QString& name);

// A spare adapter may take the place of the stored one.
[[nodiscard]] StablePort adapterPort(const QString& path, const QString& namesFolder = kStableNames);

// As checkSerialPort. What is missing for the permission is the adapter's own rule for udev.
[[nodiscard]] Result<> checkAdapterPort(const QString& device);

}  // namespace boresight

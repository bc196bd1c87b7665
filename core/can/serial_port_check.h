// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

// Why a serial port cannot be opened, in words that name the remedy. QSerialPort calls nearly everything
// "Permission error".
namespace boresight {

// Looks before opening: is it there, is it a terminal device, may we?
[[nodiscard]] Result<> checkSerialPort(const QString& path);

// The path behind all links, so that every alias of a port shares one lock; the path itself if there is none.
[[nodiscard]] QString canonicalPort(const QString& path);

}  // namespace boresight

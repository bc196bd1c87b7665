// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/base/result.h"

#include <QString>

// A serial port of this computer that is opened for its control and status lines, not for data. QSerialPort is not
// used: it needs an event loop, and it does not set what the lines do when the program dies. May block.
namespace boresight {

// Opens the port for this program alone. The kernel lowers DTR and RTS when the port is closed (HUPCL), also when the
// program dies. Names the program that has the port.
[[nodiscard]] Result<FileDescriptor> openForLines(const QString& path);
// "/dev/ttyUSB0: Input/output error", from errno.
[[nodiscard]] tl::unexpected<Error> portFailure(const QString& path, int number);

}  // namespace boresight

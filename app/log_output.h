// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace boresight::app {

// From this call on Qt's log goes to standard error without waiting for a reader. A stopped terminal or a hanging log
// collector must not stop the control of the mount, and a closed one must not end the program. Lines that do not fit
// are dropped; events.log has them. A file that exceeds its size limit causes a write error and does not end the
// program either. Call it before the application object is created.
void logToStandardError();

// Prints a line on standard error for the person who started the program. Programs without a window print texts with
// it.
void printError(const QString& line);

}  // namespace boresight::app

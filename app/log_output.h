// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace boresight::app {

// From now on Qt's log goes to standard error without ever waiting for its reader: a terminal that is stopped or a log
// collector that hangs must not stop the control of the mount, and one that went away must not end the program. Lines
// that find no room are dropped; events.log has them. A file beyond the limit of its size is an error of its writing
// and does not end the program either. Call it before the application object is made.
void logToStandardError();

// A line for whoever started the program, on standard error: how every program without a window shows a text.
void printError(const QString& line);

}  // namespace boresight::app

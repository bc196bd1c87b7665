// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// "boresight --report FILE [FILE2] --out REPORT": writes the report of one recorded pass, or of two, without a window,
// a display and a station. "boresightctl report" starts it, because boresightctl links nothing graphical.
namespace boresight::app {

[[nodiscard]] bool asksForReport(int argc, char** argv);

// Exit status: 0 done, 1 no report, or parts of a recording could not be read, 2 the command line is wrong.
[[nodiscard]] int runReport(int argc, char** argv);

}  // namespace boresight::app

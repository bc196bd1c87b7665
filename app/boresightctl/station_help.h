// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"

#include <string>

// Shared by the subcommands that ask a running station: paragraphs of their help, and their exit status.
namespace boresight::ctl {

inline const std::string kExitStatus =
    "Exit status: 0 done, 1 the station refused it, 2 the command line is wrong, 3 no station answered in 2 s.\n";

inline const std::string kWhichStation =
    R"(  --station HOST:PORT  the rotctld port of the station. Default: 127.0.0.1:4533
)";

inline const std::string kWhichLocalStation =
    R"(  --station HOST:PORT  the rotctld port of the station. Default: 127.0.0.1:4533
                       HOST is localhost, 127.0.0.1 or ::1: the station runs on this computer
)";

inline const std::string kLocalSocket =
    R"(
The command uses the local socket of the station, $XDG_RUNTIME_DIR/boresight/PORT.sock. It works on the computer of the
station, for the user who started the station. The service has the socket /run/boresight/PORT.sock, for root: use sudo.
)";

// Prints why nothing was done: the station refused, or nobody answers.
ExitStatus failedBy(const Subcommand& subcommand, const Error& error);

}  // namespace boresight::ctl

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_help.h"

namespace boresight::ctl {

ExitStatus failedBy(const Subcommand& subcommand, const Error& error)
{
    if (error.code == ErrorCode::InvalidInput) {
        return usageError(subcommand, error.text);
    }
    if (error.code != ErrorCode::Refused) {
        complain(subcommand, error.text);
        return kNoConnection;
    }
    complain(subcommand, QStringLiteral("refused: ") + error.text);
    return kFoundWrong;
}

}  // namespace boresight::ctl

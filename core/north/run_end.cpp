// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/run_end.h"

#include "core/base/text.h"

namespace boresight {

RunEnd failedRun(const QString& why)
{
    return {.outcome = why, .failed = true};
}

RunEnd brokenOff(const QString& why)
{
    return {.outcome = why, .failed = true, .holds = true};
}

QString whoEnded(const StationControl& control)
{
    switch (control.state()) {
        case StationState::Stopped:
            return Text::tr("STOP ended it: there is no result");
        case StationState::Fault:
            return Text::tr("a fault ended it: there is no result");
        default:
            return Text::tr("another command to the mount ended it: there is no result");
    }
}

}  // namespace boresight

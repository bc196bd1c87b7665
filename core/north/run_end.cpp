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
            return Text::tr("STOP ended the run. There is no result.");
        case StationState::Fault:
            return Text::tr("A fault ended the run. There is no result.");
        default:
            return Text::tr("Another command to the mount ended the run. There is no result.");
    }
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/rotctl_error.h"

#include "core/base/text.h"

namespace boresight::rotctl {
namespace {

// The numbers are those of rig_errcode_e in Hamlib.
QString meaningOf(int code)
{
    switch (-code) {
        case 1:
            return Text::tr("the value is outside the limits of rotctld");
        case 2:
            return Text::tr("rotctld is configured wrongly");
        case 4:
        case 11:
            return Text::tr("this rotator does not have the function");
        case 5:
            return Text::tr("the rotator did not answer rotctld in time");
        case 6:
            return Text::tr("rotctld cannot use the port of the rotator");
        case 8:
            return Text::tr("rotctld did not understand the answer of the rotator");
        case 9:
            return Text::tr("the rotator rejected the command");
        case 20:
            return Text::tr("the rotator is switched off");
        case 21:
            return Text::tr("the position is outside the limits of rotctld");
        case 22:
            return Text::tr("rotctld denied the access");
        default:
            return Text::tr("rotctld reported an error");
    }
}

}  // namespace

QString errorInWords(int code)
{
    return QStringLiteral("%1 (RPRT %2)").arg(meaningOf(code)).arg(code);
}

bool isUnavailable(int code)
{
    return code == -4 || code == -11;
}

}  // namespace boresight::rotctl

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/end_switch_words.h"

#include <QCoreApplication>

namespace boresight::ui {
namespace {

struct EndSwitchWords
{
    Q_DECLARE_TR_FUNCTIONS(EndSwitchWords)
};

}  // namespace

QString endName(const end_switches::EndSwitch& which)
{
    const bool isUpper = which.isUpper;
    if (which.axis == Axis::Azimuth) {
        return isUpper ? EndSwitchWords::tr("AZ upper end") : EndSwitchWords::tr("AZ lower end");
    }
    return isUpper ? EndSwitchWords::tr("EL upper end") : EndSwitchWords::tr("EL lower end");
}

QString endSwitchLine(const EndSwitchStatus& one)
{
    switch (one.state) {
        case end_switches::SwitchState::Pressed:
            return EndSwitchWords::tr("%1: pressed (%2)").arg(endName(one.which), one.input);
        case end_switches::SwitchState::Free:
            return EndSwitchWords::tr("%1: free (%2)").arg(endName(one.which), one.input);
        case end_switches::SwitchState::Unread:
            break;
    }
    return EndSwitchWords::tr("%1: not read (%2)").arg(endName(one.which), one.input) +
           (one.problem.isEmpty() ? QString() : QStringLiteral(". ") + one.problem);
}

}  // namespace boresight::ui

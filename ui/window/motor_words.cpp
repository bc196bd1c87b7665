// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/motor_words.h"

#include "core/units/degrees_text.h"
#include "ui/kit/format.h"

#include <QCoreApplication>
#include <QStringList>

namespace boresight::ui {

namespace {

struct MotorWords
{
    Q_DECLARE_TR_FUNCTIONS(MotorWords)
};

}  // namespace

QString axisHelp(const AxisStatus& axis, const std::optional<AxisCapabilities>& can)
{
    QStringList lines;
    if (!axis.stateText.isEmpty()) {
        lines << axis.stateText;
    }
    if (can && can->step > Angle{}) {
        lines << MotorWords::tr("The axis stands only at steps of %1").arg(degreesText(can->step, 3));
    }
    if (const auto& starts = axis.starts) {
        lines << MotorWords::tr("%1 motor starts in the last minute, %2 in total")
                     .arg(starts->lastMinute)
                     .arg(starts->total);
        if (starts->coast) {
            lines << MotorWords::tr("The axis coasts %1 beyond its target").arg(angleText(*starts->coast));
        }
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace boresight::ui

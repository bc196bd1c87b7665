// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/running_faults.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/sim/injection_option.h"
#include "core/sim_bus/simulated_link.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr int kTimeDecimals = 1;

QString timesText(const sim::Injection& fault)
{
    const auto seconds = [](Seconds time) { return toQString(formatFixed(time.count(), kTimeDecimals)); };
    QString text;
    if (fault.at > Seconds(0.0)) {
        text += QStringLiteral(", begins in %1 s").arg(seconds(fault.at));
    }
    if (std::isfinite(fault.duration.count())) {
        text += QStringLiteral(", lasts %1 s").arg(seconds(fault.duration));
    }
    return text;
}

}  // namespace

tl::unexpected<Error> noFaultOfARealMount()
{
    return failure(ErrorCode::NotAvailable, Text::tr("This station moves a real mount, which shows no faults on "
                                                     "request. Start it with --simulate."));
}

Result<QString> showFault(SimulatedMount& mount, const Clock& clock, AxisSet axes, std::string_view text)
{
    if (text == kEndFaults) {
        mount.pair.faults().clear();
        return QStringLiteral("No fault is simulated now.");
    }
    if (axes.empty()) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("This simulated mount has no moteus drive, and only these show faults on request."));
    }
    return sim::parseInjection(text).and_then([&](sim::Injection fault) -> Result<QString> {
        if (fault.axis && std::ranges::find(axes, *fault.axis) == axes.end()) {
            return failure(ErrorCode::NotAvailable,
                           *fault.axis == Axis::Azimuth
                               ? Text::tr("The azimuth of this mount has no simulated moteus drive.")
                               : Text::tr("The elevation of this mount has no simulated moteus drive."));
        }
        const QString words =
            QStringLiteral("Simulated fault: %1%2.").arg(toQString(sim::describe(fault)), timesText(fault));
        fault.at += clock.now() - mount.epoch;
        mount.pair.faults().add(fault);
        return words;
    });
}

}  // namespace boresight

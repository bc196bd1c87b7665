// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/bus_advice.h"

#include "core/base/text.h"
#include "core/can/bit_timing.h"

namespace boresight {
namespace {

QString timingAdvice(const BusName& bus)
{
    const QString target = QString::fromStdString(bus.target);
    if (bus.kind == BusKind::SocketCan) {
        return socketcan::looksVirtual(target)
                   ? Text::tr("%1 is a virtual bus. Is `boresightctl simulate --can %1` running?").arg(target)
                   : Text::tr(
                         "Bit timing must be 1M/5M with the sample point at 0.666 in both phases. `ip -details link "
                         "show %1` shows the values in use, and `packaging/can-up %1` sets them.")
                         .arg(target);
    }
    return Text::tr(
        "Bit timing must be 1M/5M with the sample point at 0.666 in both phases. The adapter needs can.bitrate "
        "1000000, can.fd_bitrate 5000000, can.sample_point and can.fd_sample_point 0.666 (its factory settings).");
}

}  // namespace

QString acknowledgeAdvice()
{
    return Text::tr(
        "no board acknowledges the frames: check the power of the drives, the cable, the 120 ohm at both ends and the "
        "bit rate");
}

QString errorAdvice()
{
    return Text::tr(
        "check the drives' power, the cable and its length, the 120 ohm at both ends, the bit rates and the sample "
        "points");
}

QString silenceAdvice(const BusName& bus)
{
    if (bus.kind == BusKind::Simulated) {
        return Text::tr(
            "The simulated drives do not answer. Either a fault is simulated, or their ids differ from those in the "
            "profile.");
    }
    const QString who = bus.kind == BusKind::Fdcanusb
                            ? Text::tr(
                                  "Do the ids in the profile belong to these drives? Release the bus, then "
                                  "`boresightctl scan %1` shows which drives answer.")
                            : Text::tr(
                                  "Do the ids in the profile belong to these drives? `boresightctl scan %1` shows "
                                  "which drives answer.");
    const QStringList sentences{
        Text::tr(
            "Are the drives powered? Is the cable plugged in at both ends? Does the bus have 120 ohm at both ends?"),
        timingAdvice(bus), who.arg(toQString(toString(bus)))};
    return sentences.join(QLatin1Char(' '));
}

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/bit_timing.h"

#include "core/base/text.h"

#include <QStringList>

#include <cmath>

namespace boresight::socketcan {
namespace {

// The sample points near 0.666 that adapters can set at 5 Mbit/s: 0.625 with 8 or 16 time quanta per bit (40 and 80
// MHz), 0.647 with 34 (170 MHz). The boards themselves use 0.671 and 0.706. The default of the kernel, 0.75, is wrong.
constexpr double kSamplePointTolerance = 0.05;
// The clock of an adapter may make 999 999 bit/s in place of a million. A wrongly entered rate differs by more than
// this.
constexpr double kBitRateTolerance = 0.001;

QString samplePointText(double samplePoint)
{
    return QString::number(samplePoint, 'f', 3);
}

// Each sentence has places for the found and the wanted value.
struct PhaseTexts
{
    QString bitRate;
    QString samplePoint;
};

void comparePhase(const PhaseTexts& texts, const PhaseTiming& found, const PhaseTiming& wanted, QStringList& wrong)
{
    if (std::abs(static_cast<double>(found.bitRate) - wanted.bitRate) > kBitRateTolerance * wanted.bitRate) {
        wrong << texts.bitRate.arg(found.bitRate).arg(wanted.bitRate);
    }
    if (found.samplePoint > 0.0 && std::abs(found.samplePoint - wanted.samplePoint) > kSamplePointTolerance) {
        wrong << texts.samplePoint.arg(samplePointText(found.samplePoint), samplePointText(wanted.samplePoint));
    }
}

QStringList differences(const InterfaceReport& report)
{
    QStringList wrong;
    if (report.nominal) {
        comparePhase({Text::tr("bit rate %1 (wanted %2)"), Text::tr("sample point %1 (wanted %2)")}, *report.nominal,
                     kWantedNominal, wrong);
    }
    if (report.flexibleData == false) {
        wrong << Text::tr("CAN-FD off (wanted on)");
    } else if (report.data) {
        comparePhase({Text::tr("data bit rate %1 (wanted %2)"), Text::tr("data sample point %1 (wanted %2)")},
                     *report.data, kWantedData, wrong);
    }
    return wrong;
}

}  // namespace

bool looksVirtual(const QString& interface)
{
    return interface.startsWith(QLatin1String("vcan")) || interface.startsWith(QLatin1String("vxcan"));
}

QString bringUpCommand(const QString& interface, bool isVirtual)
{
    if (isVirtual) {
        return QStringLiteral("ip link set %1 mtu 72 up").arg(interface);
    }
    return QStringLiteral(
               "ip link set %1 up type can bitrate %2 dbitrate %3 sjw 10 dsjw 5 sample-point %4 "
               "dsample-point %5 restart-ms 1000 fd on")
        .arg(interface)
        .arg(kWantedNominal.bitRate)
        .arg(kWantedData.bitRate)
        .arg(samplePointText(kWantedNominal.samplePoint), samplePointText(kWantedData.samplePoint));
}

QString timingTrouble(const InterfaceReport& report)
{
    const QStringList wrong = differences(report);
    if (report.kind != "can" || wrong.isEmpty()) {
        return {};
    }
    const QString interface = QString::fromStdString(report.name);
    return Text::tr(
               "wrong bit timing, so the drives may stay silent: %1. Enter `ip link set %2 down`, then `%3`. `ip "
               "-details link show %2` shows the values in use")
        .arg(wrong.join(QLatin1String(", ")), interface, bringUpCommand(interface, false));
}

}  // namespace boresight::socketcan

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/gpredict_settings.h"

#include <QCoreApplication>

namespace boresight::ui {

namespace {

class GpredictSettings
{
    Q_DECLARE_TR_FUNCTIONS(GpredictSettings)
};

// If the server listens on all addresses, the other computer may need any of them, so no address is shown.
QString host(const StationStatus& status)
{
    const QString listening = status.listening.section(QLatin1Char(':'), 0, -2);
    const bool everywhere = listening == QLatin1String("0.0.0.0") || listening == QLatin1String("[::]");
    return everywhere ? GpredictSettings::tr("address of this computer") : listening;
}

QString port(const StationStatus& status)
{
    return status.listening.section(QLatin1Char(':'), -1);
}

bool aroundNorth(const StationStatus& status)
{
    return status.profile->rotctld.azimuth == profile::AzimuthConvention::PlusMinus180;
}

// As written in Gpredict's dialog.
QString azimuthType(const StationStatus& status)
{
    return aroundNorth(status) ? QStringLiteral("-180° → 0° → +180°") : QStringLiteral("0° → 180° → 360°");
}

}  // namespace

QString gpredictInBrief(const StationStatus& status)
{
    return status.listening.isEmpty() ? GpredictSettings::tr("Gpredict: rotctld does not listen")
                                      : GpredictSettings::tr("Gpredict: Host %1, Port %2, Az type %3")
                                            .arg(host(status), port(status), azimuthType(status));
}

QString gpredictSettings(const StationStatus& status)
{
    return GpredictSettings::tr(
               "Gpredict: Edit > Preferences > Interfaces > Rotators > Add New\n"
               "Host: %1\n"
               "Port: %2\n"
               "Az type: %3\n"
               "Min Az: %4  Max Az: %5  Min El: 0  Max El: 90\n"
               "Antenna Control: Cycle 1000 msec, Threshold 0.1 deg\n")
        .arg(host(status), port(status), azimuthType(status),
             aroundNorth(status) ? QStringLiteral("-180") : QStringLiteral("0"),
             aroundNorth(status) ? QStringLiteral("180") : QStringLiteral("360"));
}

}  // namespace boresight::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/site_declination.h"

namespace boresight {

geomagnetism::Declination SiteDeclination::of(const profile::SensorSettings& settings) const
{
    geomagnetism::Declination declination{
        .by = settings.declinationBy, .inSensor = settings.declinationInSensor, .here = settings.declination};
    if (!settings.declinationFile.empty()) {
        declination.origin = geomagnetism::DeclinationOrigin::Model;
        const bool known = byModel && *byModel;
        declination.here = known ? std::optional(**byModel) : std::nullopt;
    }
    return declination;
}

QString SiteDeclination::doubt(const profile::SensorSettings& settings) const
{
    const bool modelCounts = !settings.declinationFile.empty();
    if (modelCounts && byModel && !*byModel) {
        return byModel->error().text;
    }
    if (modelCounts && !expiry.isEmpty()) {
        return expiry;
    }
    return modelCounts || settings.declination != Angle{} ? geomagnetism::doubt(of(settings)) : QString();
}

}  // namespace boresight

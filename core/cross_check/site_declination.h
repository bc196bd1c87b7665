// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/geomagnetism/declination.h"
#include "core/profile/sensor_settings.h"
#include "core/units/quantity.h"

#include <QString>

#include <optional>

// The declination at the site: by the magnetic model if the profile names a file of one, otherwise the value in the
// profile. Pure.
namespace boresight {

struct SiteDeclination
{
    // By the model, or why it is unknown. Empty: the model is still being read, or there is no site.
    std::optional<Result<Angle>> byModel;
    QString model;   // its name and years
    QString expiry;  // a text if the model ends soon or has ended

    [[nodiscard]] geomagnetism::Declination of(const profile::SensorSettings& settings) const;
    // Why the declination may be wrong. A value of exactly 0° was probably never entered, so no doubt is reported for
    // it.
    [[nodiscard]] QString doubt(const profile::SensorSettings& settings) const;
};

}  // namespace boresight

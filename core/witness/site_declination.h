// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/geomagnetism/declination.h"
#include "core/profile/sensor_settings.h"
#include "core/units/quantity.h"

#include <QString>

#include <optional>

// The declination at the site: what the magnetic model says of it, where the profile names a file of one, else what the
// profile says. Pure.
namespace boresight {

struct SiteDeclination
{
    // By the model, or why it is not known; empty: the model is still read, or there is no site.
    std::optional<Result<Angle>> byModel;
    QString model;   // its name and years
    QString expiry;  // that it ends or has ended

    [[nodiscard]] geomagnetism::Declination of(const profile::SensorSettings& settings) const;
    // Why it may be wrong. A declination of exactly 0° was mostly not typed at all: it accuses nobody.
    [[nodiscard]] QString doubt(const profile::SensorSettings& settings) const;
};

}  // namespace boresight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"
#include "core/geomagnetism/magnetic_field.h"
#include "core/units/site.h"

#include <QString>

#include <string>

// The World Magnetic Model: the Earth's main field and its steady change for five years from an epoch. The coefficients
// are those of the published file, whichever the operator has: none are built in, so that none grow old unseen. Pure
// values, any thread. Formulas: README.md.
namespace boresight::geomagnetism {

class MagneticModel
{
public:
    static constexpr double kYearsValid = 5.0;
    // What the change is off adds up slowly; a mount shall not lose its north on a New Year's Day.
    static constexpr double kYearsBeyond = 1.0;

    explicit MagneticModel(Coefficients coefficients) : m_coefficients(std::move(coefficients)) {}

    [[nodiscard]] const std::string& name() const { return m_coefficients.name; }
    [[nodiscard]] double validFrom() const { return m_coefficients.epoch; }
    [[nodiscard]] double validTo() const { return m_coefficients.epoch + kYearsValid; }

    // At a place, in a decimal year (decimal_year.h); refused outside of the model's five years and the one after.
    [[nodiscard]] Result<MagneticField> at(const Site& site, double year) const;

    // From its last half year on: that it ends or has ended, and what to do. Else empty.
    [[nodiscard]] QString expiry(double year) const;

private:
    Coefficients m_coefficients;
};

}  // namespace boresight::geomagnetism

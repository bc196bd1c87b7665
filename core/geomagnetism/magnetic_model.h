// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"
#include "core/geomagnetism/magnetic_field.h"
#include "core/units/site.h"

#include <QString>

#include <string>

// The World Magnetic Model: the Earth's main field and its linear change for five years from an epoch. The coefficients
// come from the published file of the operator. None are built in, because they would become outdated unnoticed. Pure
// values, any thread. Formulas: README.md.
namespace boresight::geomagnetism {

class MagneticModel
{
public:
    static constexpr double kYearsValid = 5.0;
    // The error grows slowly, and a mount must not lose its north on New Year's Day.
    static constexpr double kYearsBeyond = 1.0;

    explicit MagneticModel(Coefficients coefficients) : m_coefficients(std::move(coefficients)) {}

    [[nodiscard]] const std::string& name() const { return m_coefficients.name; }
    [[nodiscard]] double validFrom() const { return m_coefficients.epoch; }
    [[nodiscard]] double validTo() const { return m_coefficients.epoch + kYearsValid; }

    // The field at a place in a decimal year (decimal_year.h). Refused outside the five years of the model and one
    // more.
    [[nodiscard]] Result<MagneticField> at(const Site& site, double year) const;

    // A text from the last half year on: that the model ends or has ended, and what to do. Empty before.
    [[nodiscard]] QString expiry(double year) const;

private:
    Coefficients m_coefficients;
};

}  // namespace boresight::geomagnetism

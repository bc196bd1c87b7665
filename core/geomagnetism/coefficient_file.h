// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"

#include <QString>

// Reads the coefficients that the operator points to. Blocking file access: at start, or off the gui thread, nor on the
// station's. Errors begin with the file's name.
namespace boresight::geomagnetism {

[[nodiscard]] Result<Coefficients> readCoefficients(const QString& path);

}  // namespace boresight::geomagnetism

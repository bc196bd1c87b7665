// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/coefficients.h"

#include <QString>

// Reads the file of coefficients that the operator chose. Blocking file access: at the start, or neither on the gui
// thread nor on the station thread. Errors begin with the file's name.
namespace boresight::geomagnetism {

[[nodiscard]] Result<Coefficients> readCoefficients(const QString& path);

}  // namespace boresight::geomagnetism

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/profile/profile.h"

#include <optional>

namespace boresight {

// What comes into force of a profile by Apply, Undo or Redo.
struct CalibrationChange
{
    pointing::PointingTerms terms;
    std::optional<calibration::SensorMounting> sensor;

    void applyTo(profile::Profile& profile) const;
};

}  // namespace boresight

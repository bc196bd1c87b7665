// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/profile/profile.h"

#include <optional>

namespace boresight {

// The part of a profile that Apply, Undo or Redo puts into force.
struct CalibrationChange
{
    pointing::PointingTerms terms;
    std::optional<calibration::SensorMounting> sensor;

    void applyTo(profile::Profile& profile) const;
};

}  // namespace boresight

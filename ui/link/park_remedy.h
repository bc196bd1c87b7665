// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <QString>

#include <optional>

// What resolves an edit that leaves the park position where the mount may not be: the nearest place that will do. Pure.
namespace boresight::ui {

struct ParkRemedy
{
    AxisPosition place;
    QString text;  // of the button: "Move park to 15°"
};

// The same azimuth at the next elevation above that is permitted, else the nearest place. Empty: the park position is
// permitted, or nothing is.
[[nodiscard]] std::optional<ParkRemedy> parkRemedy(const profile::Profile& edited);

}  // namespace boresight::ui

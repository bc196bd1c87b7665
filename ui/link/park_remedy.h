// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <QString>

#include <optional>

// A remedy for an edit that makes the park position forbidden: the nearest allowed position. Pure.
namespace boresight::ui {

struct ParkRemedy
{
    AxisPosition place;
    QString text;  // of the button: "Move park to 15°"
};

// The same azimuth at the next permitted elevation above, otherwise the nearest permitted position. Empty if the park
// position is permitted, or nothing is.
[[nodiscard]] std::optional<ParkRemedy> parkRemedy(const profile::Profile& edited);

}  // namespace boresight::ui

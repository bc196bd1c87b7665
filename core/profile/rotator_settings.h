// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <string>

// Settings of a rotator with a control box. Plain values, any thread.
namespace boresight::profile {

// On for motors that are only switched on and off, to start them seldom.
enum class RareStarts
{
    Off,
    On
};

// Of motors that are only switched on and off. Zero stands for what Boresight computes or measures itself.
struct RotatorSettings
{
    RareStarts rareStarts = RareStarts::Off;
    Angle deadBand{};
    int mostStarts = 30;  // of each motor in a minute; 0: any number
    Angle coast{};
    std::string sensorOffsets;  // that the box reported when they were saved; empty: none

    bool operator==(const RotatorSettings&) const = default;
};

}  // namespace boresight::profile

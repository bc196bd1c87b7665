// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

#include <chrono>
#include <optional>

// The further axis beside the two, such as the polarisation. It is watched and jogged, and points nothing. Plain
// values. Mechanical angles.
namespace boresight {

struct ThirdAxisStatus
{
    enum class State
    {
        NoData,
        Off,      // nothing holds it
        Holding,  // the drive holds it
        Moving,
        Fault,
    };

    QString name;  // of the profile
    State state = State::NoData;
    std::optional<Angle> place;  // last measured, of any age; empty: the drive does not know it
    std::optional<AngularRate> rate;
    std::optional<std::chrono::milliseconds> age;  // of the last reply
    TravelRange travel;
    AngularRate fastest;
    QString mode;                            // in the words of the drive
    QString fault;                           // in the words of the drive; empty: none
    std::optional<double> boardTemperature;  // °C
};

}  // namespace boresight

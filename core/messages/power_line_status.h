// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <cstdint>
#include <optional>

// The state of the line by which the received power arrives, for the screen. Plain values.
namespace boresight {

struct PowerLineStatus
{
    QString name;                    // "UDP 127.0.0.1:4540"; empty: the profile names none
    QString problem;                 // empty: no problem
    std::optional<double> decibels;  // the last value
    Seconds age{0.0};                // of the last value
    std::uint64_t values = 0;        // how many values were received
    std::uint64_t refused = 0;       // how many lines were refused
};

}  // namespace boresight

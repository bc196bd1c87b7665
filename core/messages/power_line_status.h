// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <cstdint>
#include <optional>

// How the line of the received power does, for the screen. Plain values.
namespace boresight {

struct PowerLineStatus
{
    QString name;                    // "UDP 127.0.0.1:4540"; empty: the profile names none
    QString problem;                 // one sentence; empty: all is well
    std::optional<double> decibels;  // the last value
    Seconds age{0.0};                // of it
    std::uint64_t values = 0;        // since the line was opened
    std::uint64_t refused = 0;       // lines that could not be read for sure
};

}  // namespace boresight

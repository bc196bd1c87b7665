// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>
#include <span>

// What an axis was asked to do and what it did, by time, and the figures that every kind of run has. Plain values, any
// thread; mechanical angles.
namespace boresight::response {

struct Sample
{
    Seconds time{0.0};
    Angle wanted;                    // the set-point
    Angle actual;                    // the answer to it
    std::optional<double> torque{};  // Nm
};

using Samples = std::span<const Sample>;

// Of the tracking error, actual minus wanted.
struct ErrorFigures
{
    Angle rms;
    Angle peak;  // its size

    bool operator==(const ErrorFigures&) const = default;
};

struct TorqueFigures
{
    double rms = 0.0;   // Nm
    double peak = 0.0;  // Nm, its size

    bool operator==(const TorqueFigures&) const = default;
};

[[nodiscard]] ErrorFigures errorFigures(Samples samples);
// Empty where nothing reports a torque.
[[nodiscard]] std::optional<TorqueFigures> torqueFigures(Samples samples);

}  // namespace boresight::response

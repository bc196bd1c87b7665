// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

// The output that permits a transmitter to transmit while the beam is on its target. Plain values.
namespace boresight::profile {

enum class InSimulation
{
    Off,  // the real antenna does not point where the simulated mount points
    On
};

struct TransmitSettings
{
    std::string output;          // "file:/run/transmit", see contacts/output_name.h; empty: none
    double beamFraction = 0.25;  // the largest pointing error at which the output is on, as a part of the beam width
    InSimulation inSimulation = InSimulation::Off;

    bool operator==(const TransmitSettings&) const = default;
};

}  // namespace boresight::profile

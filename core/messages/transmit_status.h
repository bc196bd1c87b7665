// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <optional>

// Whether the transmitter may transmit. The output in the profile is on only while the beam is on its target.
namespace boresight {

struct TransmitStatus
{
    QString output;                   // its name in the profile; empty: the profile names none
    bool on = false;                  // as last reported by the output
    QString whyOff;                   // what keeps the output off; empty: nothing
    QString problem;                  // of the output; empty: none
    Angle within;                     // the output is on only while the error is smaller
    std::optional<Angle> error = {};  // angle on the sky between beam and target
};

}  // namespace boresight

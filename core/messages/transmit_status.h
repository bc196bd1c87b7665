// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QString>

#include <optional>

// Whether the transmitter may transmit. The output in the profile is on only while the beam is on its target.
namespace boresight {

struct TransmitStatus
{
    QString output;                   // as the profile names it; empty: it names none
    bool on = false;                  // by the last word of the output
    QString whyOff;                   // what keeps it off; empty: nothing
    QString problem;                  // of the output; empty: it works
    Angle within;                     // the largest error with which it is on
    std::optional<Angle> error = {};  // of the beam, on the sky
};

}  // namespace boresight

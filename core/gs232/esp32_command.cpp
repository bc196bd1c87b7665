// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_command.h"

#include "core/base/numbers.h"

namespace boresight::gs232::esp32 {

std::string goTo(Axis axis, Angle angle)
{
    const bool isAzimuth = axis == Axis::Azimuth;
    const Angle sent = isAzimuth ? angle.wrapped360() : angle;
    return (isAzimuth ? "AZ " : "EL ") + formatFixed(sent.degrees(), 1) + "\r";
}

}  // namespace boresight::gs232::esp32
